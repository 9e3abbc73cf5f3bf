package troupe.app.help;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Desktop;
import java.awt.Dimension;
import java.io.IOException;
import java.net.URI;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Hashtable;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Executor;
import javax.swing.DefaultListModel;
import javax.swing.JEditorPane;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import javax.swing.event.HyperlinkEvent;
import javax.swing.text.BadLocationException;
import javax.swing.text.html.HTMLDocument;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.StyleSheet;
import troupe.app.look.Failures;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.paint.Tone;

/** Shows the user guide: its headings to the left, the page to the right, and a field to search it. */
public final class GuidePanel extends JPanel {
    private static final int SIDE = 244;

    private final transient Look look;
    private final transient Executor background;
    private final transient Executor eventThread;
    private final transient GuidePages pages;
    private final JEditorPane text = new JEditorPane();
    private final DefaultListModel<String> headings = new DefaultListModel<>();
    private final JList<String> contents = new JList<>(headings);
    private final SearchField query;
    private final FlatButton back;
    private final transient Deque<String> visited = new ArrayDeque<>();

    /** Makes the panel and begins to read the guide on {@code background}. */
    public GuidePanel(Look look, Executor background, Executor eventThread) {
        super(new BorderLayout(16, 10));
        this.look = look;
        this.background = background;
        this.eventThread = eventThread;
        this.pages = new GuidePages(look.texts().locale(), look.scale());
        setName("guide.panel");
        setOpaque(false);
        back = new FlatButton(look, FlatButton.Style.PILL);
        back.setText(look.text("guide.back"));
        back.setName("guide.back");
        back.addActionListener(e -> goBack());
        query = new SearchField(look, "guide.query", look.text("guide.find"));
        query.addActionListener(e -> find());
        JPanel top = new JPanel(new BorderLayout(8, 0));
        top.setOpaque(false);
        top.add(back, BorderLayout.WEST);
        top.add(query, BorderLayout.CENTER);
        add(top, BorderLayout.NORTH);
        dressContents();
        JScrollPane side = ThinScrollBarUI.scroll(contents, look);
        side.setPreferredSize(new Dimension(SIDE, 100));
        add(side, BorderLayout.WEST);
        dressText();
        add(ThinScrollBarUI.scroll(text, look), BorderLayout.CENTER);
        read(GuidePages.FIRST);
    }

    private void dressContents() {
        contents.setName("guide.contents");
        contents.setFont(look.font());
        contents.setBackground(look.color(Tone.PANEL));
        contents.setForeground(look.color(Tone.DIM));
        contents.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        contents.setFixedCellHeight(26);
        contents.getAccessibleContext().setAccessibleName(look.text("guide.contents"));
        contents.addListSelectionListener(e -> {
            if (contents.getSelectedIndex() >= 0) {
                text.scrollToReference("h" + contents.getSelectedIndex());
            }
        });
    }

    private void dressText() {
        HTMLEditorKit kit = new HTMLEditorKit();
        StyleSheet own = new StyleSheet();
        own.addStyleSheet(kit.getStyleSheet());
        int body = look.px(13);
        String ink = "color:" + hex(look.color(Tone.TEXT)) + ";";
        own.addRule("body{font-family:SansSerif;font-size:" + body + "px;" + ink + "margin:0}");
        own.addRule("h1{font-size:" + look.px(20) + "px;margin:0 0 " + look.px(8) + "px 0}");
        own.addRule("h2{font-size:" + look.px(16) + "px;margin:" + look.px(18) + "px 0 " + look.px(6) + "px 0}");
        own.addRule("h3{font-size:" + look.px(14) + "px;margin:" + look.px(12) + "px 0 " + look.px(4) + "px 0}");
        own.addRule("p{margin:0 0 " + look.px(8) + "px 0}");
        own.addRule("ul,ol{margin:0 0 " + look.px(8) + "px " + look.px(22) + "px}");
        own.addRule("li{margin:0 0 " + look.px(4) + "px 0}");
        own.addRule("code,pre{font-family:Monospaced;font-size:" + look.px(12) + "px}");
        own.addRule("td,th{font-size:" + body + "px}");
        own.addRule("a{color:" + hex(look.color(Tone.ACCENT)) + "}");
        HTMLDocument empty = new HTMLDocument(own);
        empty.setAsynchronousLoadPriority(-1);
        text.putClientProperty(JEditorPane.W3C_LENGTH_UNITS, true);
        text.setEditorKit(kit);
        text.setDocument(empty);
        text.setName("guide.text");
        text.setEditable(false);
        text.setBackground(look.color(Tone.PANEL));
        text.setForeground(look.color(Tone.TEXT));
        text.setSelectionColor(look.mix(Tone.ACCENT, Tone.PANEL, 0.35));
        text.setSelectedTextColor(look.color(Tone.TEXT));
        text.getAccessibleContext().setAccessibleName(look.text("guide.title"));
        text.addHyperlinkListener(event -> {
            if (event.getEventType() == HyperlinkEvent.EventType.ACTIVATED) {
                follow(event.getDescription());
            }
        });
    }

    private static String hex(Color color) {
        return String.format(Locale.ROOT, "#%06x", color.getRGB() & 0xffffff);
    }

    private void follow(String link) {
        String page = link.replaceAll("#.*", "");
        if (GuidePages.has(page)) {
            read(page);
        } else if (link.contains("://") && Desktop.isDesktopSupported()) {
            background.execute(() -> browse(link));
        }
    }

    private static void browse(String link) {
        try {
            Desktop.getDesktop().browse(URI.create(link));
        } catch (IOException | UnsupportedOperationException e) {
            System.getLogger(GuidePanel.class.getName()).log(System.Logger.Level.DEBUG, "no browser", e);
        }
    }

    private void goBack() {
        back.setSelected(false);
        if (visited.size() > 1) {
            visited.pop();
            read(visited.pop());
        }
    }

    private void read(String page) {
        visited.push(page);
        back.setEnabled(visited.size() > 1);
        background.execute(() -> {
            try {
                GuidePages.Read read = pages.read(page);
                eventThread.execute(() -> show(read));
            } catch (IOException e) {
                Markdown.Page none = new Markdown.Page("<p>" + look.texts().tell(Failures.line(e)) + "</p>", List.of());
                eventThread.execute(() -> show(new GuidePages.Read(none, Map.of())));
            }
        });
    }

    private void show(GuidePages.Read read) {
        // pictures that are there already are not fetched in the background, by threads that paint
        text.getDocument().putProperty("imageCache", new Hashtable<>(read.pictures()));
        text.setText("<html><body>" + read.page().html() + "</body></html>");
        text.setCaretPosition(0);
        headings.clear();
        headings.addAll(read.page().headings());
    }

    /** Marks the next place that holds the words, from the one that is marked on; from the top after the last. */
    private void find() {
        String wanted = query.getText().strip().toLowerCase(Locale.ROOT);
        if (wanted.isEmpty()) {
            return;
        }
        try {
            String all = text.getDocument()
                    .getText(0, text.getDocument().getLength())
                    .toLowerCase(Locale.ROOT);
            int at = all.indexOf(wanted, text.getSelectionEnd());
            at = at < 0 ? all.indexOf(wanted) : at;
            query.setForeground(look.color(at < 0 ? Tone.MOVE : Tone.TEXT));
            if (at >= 0) {
                text.select(at, at + wanted.length());
                text.getCaret().setSelectionVisible(true);
                text.scrollRectToVisible(text.modelToView2D(at).getBounds());
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException("a place in the page that is not in it", e);
        }
    }
}
