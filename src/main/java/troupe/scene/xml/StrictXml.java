package troupe.scene.xml;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URL;
import java.util.Locale;
import java.util.Optional;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.ValidatorHandler;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;
import org.xml.sax.helpers.DefaultHandler;

/**
 * Parses XML that may come from anywhere: document types and external references are refused, and what is wrong is
 * said in English on every machine, so that it can be told in other words. Safe on any thread.
 */
public final class StrictXml {
    /** Names the language of parsers and validators; the root's texts are the English ones. */
    private static final String LOCALE = "http://apache.org/xml/properties/locale";

    private StrictXml() {}

    /**
     * Reads a schema of this program. Cost O(size); a schema is immutable and may be kept.
     *
     * @throws IllegalStateException if it is none
     */
    public static Schema schema(URL url) {
        try {
            SchemaFactory factory = SchemaFactory.newDefaultInstance();
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
            return factory.newSchema(url);
        } catch (SAXException e) {
            throw new IllegalStateException("the program's own schema " + url + " cannot be read", e);
        }
    }

    /**
     * Parses bytes, validated while they stream if there is a schema. Cost O(size).
     *
     * @param handler is told the content and the errors
     * @throws SAXException if they are not well-formed, or the handler throws it
     * @throws IOException if they are not text of their encoding
     */
    public static void parse(byte[] bytes, Optional<Schema> schema, DefaultHandler handler)
            throws SAXException, IOException {
        XMLReader reader = parser();
        reader.setErrorHandler(handler);
        reader.setEntityResolver((publicId, systemId) -> {
            throw new SAXException("external references are not allowed");
        });
        if (schema.isPresent()) {
            ValidatorHandler validator = schema.get().newValidatorHandler();
            validator.setProperty(LOCALE, Locale.ROOT);
            validator.setContentHandler(handler);
            validator.setErrorHandler(handler);
            reader.setContentHandler(validator);
        } else {
            reader.setContentHandler(handler);
        }
        reader.parse(new InputSource(new ByteArrayInputStream(bytes)));
    }

    private static XMLReader parser() throws SAXException {
        try {
            SAXParserFactory factory = SAXParserFactory.newDefaultInstance();
            factory.setNamespaceAware(true);
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            XMLReader reader = factory.newSAXParser().getXMLReader();
            reader.setProperty(LOCALE, Locale.ROOT);
            return reader;
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException("the JDK's own XML parser lacks a standard feature", e);
        }
    }
}
