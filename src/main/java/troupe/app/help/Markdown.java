package troupe.app.help;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Turns the Markdown that the pages of {@code docs/} use into HTML 3.2, as the JDK shows it: headings, paragraphs, lists,
 * tables, blocks of code, pictures, links, bold, italic and code. Pure; an answer costs O(characters).
 */
final class Markdown {
    private static final Pattern HEADING = Pattern.compile("(#{1,4}) +(.*)");
    private static final Pattern ITEM = Pattern.compile("(?:[-*]|(\\d+)\\.) +(.*)");
    private static final Pattern IMAGE = Pattern.compile("!\\[([^\\]]*)\\]\\(([^)]+)\\)");
    private static final Pattern CODE = Pattern.compile("`([^`]+)`");

    private final StringBuilder html = new StringBuilder();
    private final List<String> headings = new ArrayList<>();
    private final Function<String, Optional<String>> pictures;
    private final StringBuilder paragraph = new StringBuilder();
    private String list = "";

    /** A page as HTML, and its headings of the second order, each of which is the anchor {@code h0}, {@code h1}, … */
    record Page(String html, List<String> headings) {}

    private Markdown(Function<String, Optional<String>> pictures) {
        this.pictures = pictures;
    }

    /** Turns a page; {@code pictures} gives the tag of a picture by its path, nothing for one to be left out. */
    static Page page(String text, Function<String, Optional<String>> pictures) {
        Markdown page = new Markdown(pictures);
        page.blocks(text.split("\n", -1));
        return new Page(page.html.toString(), List.copyOf(page.headings));
    }

    private void blocks(String[] lines) {
        int i = 0;
        while (i < lines.length) {
            String line = lines[i].stripTrailing();
            Matcher heading = HEADING.matcher(line);
            Matcher image = IMAGE.matcher(line);
            Matcher item = ITEM.matcher(line);
            if (line.startsWith("```")) {
                i = code(lines, i);
            } else if (line.startsWith("|")) {
                i = table(lines, i);
            } else if (heading.matches()) {
                heading(heading.group(1).length(), heading.group(2));
            } else if (image.matches()) {
                end();
                pictures.apply(image.group(2))
                        .ifPresent(tag -> html.append("<p>").append(tag).append("</p>\n"));
            } else if (item.matches()) {
                item(item.group(1) == null ? "ul" : "ol", item.group(2));
            } else if (line.isBlank()) {
                flush();
            } else {
                if (!line.startsWith(" ") && paragraph.length() == 0) {
                    end();
                }
                paragraph.append(paragraph.length() == 0 ? "" : " ").append(line.strip());
            }
            i++;
        }
        end();
    }

    private void heading(int order, String text) {
        end();
        if (order == 2) {
            html.append("<a name=\"h").append(headings.size()).append("\"></a>");
            headings.add(text.replace("`", ""));
        }
        html.append("<h")
                .append(order)
                .append('>')
                .append(inline(text))
                .append("</h")
                .append(order)
                .append(">\n");
    }

    private void item(String kind, String text) {
        flush();
        if (!list.equals(kind)) {
            end();
            html.append('<').append(kind).append(">\n");
            list = kind;
        }
        paragraph.append("<li>").append(text);
    }

    /** Writes the paragraph, or the item, that was being read. */
    private void flush() {
        if (paragraph.length() > 0) {
            boolean item = paragraph.indexOf("<li>") == 0;
            String text = inline(paragraph.substring(item ? "<li>".length() : 0));
            html.append(item ? "<li>" + text + "</li>\n" : "<p>" + text + "</p>\n");
            paragraph.setLength(0);
        }
    }

    private void end() {
        flush();
        if (!list.isEmpty()) {
            html.append("</").append(list).append(">\n");
            list = "";
        }
    }

    private int code(String[] lines, int from) {
        end();
        html.append("<pre>");
        int i = from + 1;
        while (i < lines.length && !lines[i].startsWith("```")) {
            html.append(escaped(lines[i])).append('\n');
            i++;
        }
        html.append("</pre>\n");
        return i;
    }

    private int table(String[] lines, int from) {
        end();
        html.append("<table cellspacing=\"0\" cellpadding=\"3\">\n");
        int i = from;
        while (i < lines.length && lines[i].startsWith("|")) {
            boolean rule = lines[i].matches("[|\\s:-]+");
            if (!rule) {
                String cell = i == from ? "th" : "td";
                String row = lines[i].strip();
                html.append("<tr>");
                for (String part : row.substring(1, row.length() - (row.endsWith("|") ? 1 : 0))
                        .split("(?<!\\\\)\\|")) {
                    html.append('<').append(cell).append(" align=\"left\" valign=\"top\">");
                    html.append(inline(part.strip().replace("\\|", "|")))
                            .append("</")
                            .append(cell)
                            .append('>');
                }
                html.append("</tr>\n");
            }
            i++;
        }
        html.append("</table>\n");
        return i - 1;
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    /** Turns what stands within a line: code is only escaped, the rest may be bold, italic or a link. */
    private static String inline(String text) {
        List<String> codes = new ArrayList<>();
        String kept = CODE.matcher(text).replaceAll(match -> {
            codes.add(match.group(1));
            return "\u0000" + (codes.size() - 1) + "\u0000";
        });
        String marked = escaped(kept)
                .replaceAll("\\*\\*(.+?)\\*\\*", "<b>$1</b>")
                .replaceAll("(?<![\\w*])\\*([^*\\s][^*]*?)\\*(?![\\w*])", "<i>$1</i>")
                .replaceAll("\\[([^\\]]+)\\]\\(([^)]+)\\)", "<a href=\"$2\">$1</a>");
        for (int i = 0; i < codes.size(); i++) {
            marked = marked.replace("\u0000" + i + "\u0000", "<code>" + escaped(codes.get(i)) + "</code>");
        }
        return marked;
    }
}
