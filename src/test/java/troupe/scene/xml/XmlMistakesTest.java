package troupe.scene.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Breaks the text of a scene in the ways in which people do. */
class XmlMistakesTest {
    private static final String SCENE = """
            <scene xmlns="urn:troupe:scene:1">
              <world width="6" depth="4"/>
              <actor id="anna"><walk/></actor>
            </scene>
            """;

    private final Locale before = Locale.getDefault();

    @BeforeEach
    void speakEnglish() {
        Locale.setDefault(Locale.ENGLISH);
    }

    @AfterEach
    void speakAsBefore() {
        Locale.setDefault(before);
    }

    @Test
    void brokenTextIsToldInPlainWordsWithPlaceAndCure() {
        assertTold("1: column 1: the file is empty or ends at once; a scene begins with <scene …>", "");
        assertTold("the file ends in the middle; it may be cut off", SCENE.substring(0, SCENE.indexOf("</actor>")));
        assertTold("1: column 1: this is not XML: there is text before the first <; give a", "type octile\nmap\n");
        assertTold("there is something after </scene>; take it away", SCENE + "more");
        assertTold("<walk> is not closed where its parent is; write </walk>, or", SCENE.replace("<walk/>", "<walk>"));
        assertTold("the value of id has no quotes; write id=\"…\"", SCENE.replace("\"anna\"", "anna"));
        assertTold("id has no value; write id=\"…\"", SCENE.replace("id=\"anna\"", "id"));
        assertTold("the value of id holds <, or its quote is not closed", SCENE.replace("anna\">", "anna>"));
        assertTold("<actor> has id twice; take one away", SCENE.replace("id=", "id=\"b\" id="));
        assertTold("there is a lone &; write &amp; for it", SCENE.replace("anna", "a & b"));
        assertTold("&eacute; is unknown; write the character", SCENE.replace("anna", "&eacute;"));
        assertTold("the file has a DOCTYPE, which scenes may not have", "<!DOCTYPE scene>" + SCENE);
        assertTold("the tag <actor … is broken off; close it", SCENE.replace("\"anna\">", "\"anna\""));
    }

    @Test
    void bytesThatAreNoTextAreToldInPlainWords() {
        byte[] bytes = SCENE.replace("anna", "ann\u00e9").getBytes(StandardCharsets.ISO_8859_1);
        assertTold("the file is not UTF-8 text; save it as UTF-8", bytes);
    }

    private static void assertTold(String told, String text) {
        assertTold(told, text.getBytes(StandardCharsets.UTF_8));
    }

    private static void assertTold(String told, byte[] bytes) {
        SceneException e =
                assertThrows(SceneException.class, () -> SceneXml.read(new ByteArrayInputStream(bytes), "a.xml"));
        assertEquals(true, e.getMessage().contains(told), e.getMessage());
        assertEquals(true, e.getMessage().matches("(?s)a.xml:[^;]*\\d+[^;]*column \\d+: .*"), e.getMessage());
    }
}
