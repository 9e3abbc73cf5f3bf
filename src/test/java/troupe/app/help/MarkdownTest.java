package troupe.app.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class MarkdownTest {
    private static String html(String text) {
        return Markdown.page(text, path -> Optional.of("<img " + path + ">")).html();
    }

    @Test
    void linesBecomeParagraphsHeadingsAndPictures() {
        assertEquals("<h1>A &lt; B</h1>\n<p>one two</p>\n<p>three</p>\n", html("# A < B\none\ntwo\n\nthree\n"));
        assertEquals("<p><img pictures/a.png></p>\n", html("![What it shows](pictures/a.png)"));
        assertEquals(
                "", Markdown.page("![gone](x.png)", path -> Optional.empty()).html());
    }

    @Test
    void itemsGoOnInLinesThatStandIn() {
        assertEquals(
                "<ul>\n<li>one more</li>\n<li>two</li>\n</ul>\n<p>after</p>\n", html("- one\n  more\n- two\n\nafter"));
        assertEquals("<ol>\n<li>one</li>\n<li>two</li>\n</ol>\n", html("1. one\n2. two"));
    }

    @Test
    void boldLinksAndCodeAreMarkedAndCodeIsLeftAlone() {
        assertEquals(
                "<p>a <b>bold <code>x*y*z</code></b> and <i>leaning</i></p>\n",
                html("a **bold `x*y*z`** and *leaning*"));
        assertEquals("<p><a href=\"b.md\"><code>b</code></a> 2 * 3 * 4</p>\n", html("[`b`](b.md) 2 * 3 * 4"));
        assertEquals("<pre>a &amp;&amp; **b**\n</pre>\n", html("```\na && **b**\n```"));
    }

    @Test
    void tablesHaveAHeadAndRows() {
        assertEquals(
                "<table cellspacing=\"0\" cellpadding=\"3\">\n"
                        + "<tr><th align=\"left\" valign=\"top\">key</th><th align=\"left\" valign=\"top\">does</th></tr>\n"
                        + "<tr><td align=\"left\" valign=\"top\">a</td><td align=\"left\" valign=\"top\"></td></tr>\n"
                        + "</table>\n",
                html("| key | does |\n| --- | --- |\n| a |  |\n"));
    }

    @Test
    void everyPageOfTheGuideIsThereAndNothingOfItIsLost() throws IOException {
        GuidePages pages = new GuidePages(Locale.ENGLISH, 1);
        try (Stream<Path> docs = Files.list(Path.of("docs"))) {
            List<Path> all =
                    docs.filter(p -> p.toString().endsWith(".md")).sorted().toList();
            assertTrue(all.size() > 8);
            for (Path page : all) {
                String name = page.getFileName().toString();
                assertTrue(GuidePages.has(name), name);
                String shown =
                        pages.read(name).page().html().replaceAll("<[^>]*>", "").replaceAll("\\s+", " ");
                for (String word : Files.readString(page)
                        .replaceAll("(?m)^```\\w+", " ")
                        .replaceAll("!?\\[([^\\]]*)\\]\\([^)]*\\)", " ")
                        .split("[^\\p{L}]+")) {
                    assertTrue(shown.contains(word), name + ": '" + word + "' is missing");
                }
            }
        }
        assertEquals(
                Files.readAllLines(Path.of("docs/guide.md")).stream()
                        .filter(line -> line.startsWith("## "))
                        .count(),
                pages.read("guide.md").page().headings().size());
        assertFalse(GuidePages.has("../pom.md"));
        assertFalse(GuidePages.has("nothing.md"));
    }
}
