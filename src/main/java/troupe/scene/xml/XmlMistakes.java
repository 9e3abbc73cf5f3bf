package troupe.scene.xml;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Says the commonest errors of the XML parser and of the schema in plain words, with a cure. What it does not know is left as the
 * parser says it.
 */
public final class XmlMistakes {
    /**
     * What is wrong, and what to do.
     *
     * @param cure empty where none is known
     */
    public record Mistake(String message, String cure) {}

    private record Rule(Pattern said, String message, String cure) {}

    private static final List<Rule> RULES = List.of(
            rule("Premature end of file\\.", "the file is empty or ends at once", "a scene begins with <scene …>"),
            rule(
                    "XML document structures must start and end within the same entity\\.",
                    "the file ends in the middle",
                    "it may be cut off; the last line must be </scene>"),
            rule(
                    "Content is not allowed in prolog\\.|Reference is not allowed in prolog\\.|The markup in the document preceding the root .*",
                    "this is not XML: there is text before the first <",
                    "give a scene file; a map or drawing is read by troupe import, a run by troupe replay"),
            rule(
                    "Invalid byte .*UTF-8 sequence\\.",
                    "the file is not UTF-8 text",
                    "save it as UTF-8; a run is read by troupe replay"),
            rule(
                    "Content is not allowed in trailing section\\.|The markup in the document following the root .*",
                    "there is something after </scene>",
                    "take it away"),
            rule(
                    "The element type \"([^\"]*)\" must be terminated by the matching end-tag .*",
                    "<$1> is not closed where its parent is",
                    "write </$1>, or end the tag with />"),
            rule(
                    "Element type \"([^\"]*)\" must be followed by either attribute specifications.*",
                    "the tag <$1 … is broken off",
                    "close it with > or />, with a space before each attribute"),
            rule(
                    "Open quote is expected for attribute \"([^\"]*)\".*",
                    "the value of $1 has no quotes",
                    "write $1=\"…\""),
            rule("Attribute name \"([^\"]*)\" .*must be followed by.*", "$1 has no value", "write $1=\"…\""),
            rule(
                    "The value of attribute \"([^\"]*)\" .*must not contain the '<' character\\.",
                    "the value of $1 holds <, or its quote is not closed",
                    "close the quote, or write &lt;"),
            rule(
                    "Attribute \"([^\"]*)\" was already specified for element \"([^\"]*)\"\\.",
                    "<$2> has $1 twice",
                    "take one away"),
            rule(
                    "The entity name must immediately follow the '&'.*|The reference to entity .* must end with.*",
                    "there is a lone &",
                    "write &amp; for it"),
            rule(
                    "The entity \"([^\"]*)\" was referenced, but not declared\\.",
                    "&$1; is unknown",
                    "write the character"),
            rule("DOCTYPE is disallowed .*", "the file has a DOCTYPE, which scenes may not have", "take it away"),
            rule(
                    "The content of elements must consist of well-formed character data or markup\\.",
                    "there is a < that begins no tag",
                    "write &lt; for it"),
            rule(
                    "The end-tag for element type \"([^\"]*)\" must end with a '>' delimiter\\.",
                    "the tag </$1 … is broken off",
                    "close it with >"),
            rule(
                    ".*in the XML declaration.*|XML version .*|The XML declaration must .*|Invalid encoding name .*"
                            + "|A pseudo attribute name .*|.* processing instruction .*|The encoding .*",
                    "the first line, <?xml …?>, is broken",
                    "leave it out"),
            rule(
                    "Cannot find the declaration of element '([^']*)'\\.",
                    "the file begins with <$1>",
                    "a scene begins with <scene xmlns=\"" + SceneXml.NAMESPACE + "\" …>"),
            rule(
                    "Invalid content was found starting with element '(.*)'\\. One of '(.*)' is expected\\.",
                    "<$1> does not belong here",
                    "write one of $2"),
            rule(
                    "Invalid content was found starting with element '(.*)'\\. No child element .*",
                    "<$1> does not belong here",
                    "take it away"),
            rule(
                    "'(.*)' can occur a maximum of '(.*)' times .*",
                    "<$1> is there more often than $2 times",
                    "take one away"),
            rule(
                    "The content of element '(.*)' is not complete\\. One of '(.*)' is expected\\.",
                    "<$1> is not complete",
                    "put one of $2 into it"),
            rule(
                    "Element '([^']*)' must have no character or element .*",
                    "<$1> holds something",
                    "take it away, and end the tag with />"),
            rule("Element '([^']*)' cannot have character .*", "there is text in <$1>", "take it away"),
            rule(
                    "Attribute '([^']*)' is not allowed to appear in element '([^']*)'\\.",
                    "<$2> has no attribute \"$1\"",
                    "take it away"),
            rule(
                    "Attribute '([^']*)' must appear on element '([^']*)'\\.",
                    "<$2> lacks the attribute \"$1\"",
                    "write $1=\"…\""),
            value(".* enumeration '\\[(.*)]'\\..*", "write one of $4"),
            value(".* maxInclusive '(.*)' for type .*", "write at most $4"),
            value(".* minInclusive '(.*)' for type .*", "write at least $4"),
            value(".* pattern '\\(#.*", "write it as #rrggbb, or leave it out"),
            value(".* is not a valid value for 'boolean'\\.", "write true or false"),
            value(".* is not a valid value for '(?:integer|int|long)'\\.", "write a whole number"),
            value(".* is not a valid value for '(?:double|decimal)'\\.", "write a number"),
            value("(?: .*)?", "look the attribute up in the page of the format"),
            rule(
                    "Value '(.*)' (?:with length = .* )?is not facet-valid with respect to .*",
                    "'$1' is out of place",
                    ""),
            rule("'(.*)' is not a valid value for '.*'\\.", "'$1' is out of place", ""));

    private XmlMistakes() {}

    private static Rule rule(String said, String message, String cure) {
        return new Rule(Pattern.compile(said), message, cure);
    }

    /** Makes the rule for a value of an attribute; the schema says first that it is wrong, then in what. */
    private static Rule value(String what, String cure) {
        String which = "The value '(.*)' of attribute '([^']*)' on element '([^']*)' is not valid .*? type, '[^']*'\\.";
        return rule(which + what, "<$3 … $2=\"$1\"> is not allowed", cure);
    }

    /** Returns a message without the code that the schema's begin with. */
    public static String bare(String message) {
        return message.replaceAll("^cvc-[^:]*: ", "");
    }

    /** Returns a message of the parser or the schema, without its code, in plain words, or as it is. Cost O(rules). */
    public static Mistake of(String message) {
        for (Rule rule : RULES) {
            Matcher matcher = rule.said().matcher(message);
            if (matcher.matches()) {
                return new Mistake(matcher.replaceFirst(rule.message()), matcher.replaceFirst(rule.cure()));
            }
        }
        return new Mistake(message, "");
    }
}
