package troupe.scene.xml;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Says the commonest errors of the XML parser in plain words, with a cure. What it does not know is left as the
 * parser says it.
 */
final class XmlMistakes {
    /**
     * What is wrong, and what to do.
     *
     * @param cure empty where none is known
     */
    record Mistake(String message, String cure) {}

    private record Rule(Pattern said, String message, String cure) {}

    private static final List<Rule> RULES = List.of(
            rule("Premature end of file\\.", "the file is empty or ends at once", "a scene begins with <scene …>"),
            rule(
                    "XML document structures must start and end within the same entity\\.",
                    "the file ends in the middle",
                    "it may be cut off; the last line must be </scene>"),
            rule(
                    "Content is not allowed in prolog\\.|The markup in the document preceding the root .*",
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
            rule("DOCTYPE is disallowed .*", "the file has a DOCTYPE, which scenes may not have", "take it away"));

    private XmlMistakes() {}

    private static Rule rule(String said, String message, String cure) {
        return new Rule(Pattern.compile(said), message, cure);
    }

    /** Returns a message of the parser in plain words, or as it is. */
    static Mistake of(String message) {
        for (Rule rule : RULES) {
            Matcher matcher = rule.said().matcher(message);
            if (matcher.matches()) {
                return new Mistake(matcher.replaceFirst(rule.message()), matcher.replaceFirst(rule.cure()));
            }
        }
        return new Mistake(message, "");
    }
}
