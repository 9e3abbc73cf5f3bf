package troupe.app.tour;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import troupe.app.look.Icons;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.paint.Tone;

/** Shows a few words with buttons below, on a card that can be dragged aside. */
final class TourCard extends JPanel {
    private static final int WIDTH = 312;
    private static final int ARC = 12;

    private final transient Look look;
    private final JLabel place;
    private final JLabel title;
    private final JTextArea text;
    private final JTextArea done;
    private final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 6, 0));
    private boolean dragged;

    /** Makes an empty card; {@code close} is what Escape and the cross do. */
    TourCard(Look look, Runnable close) {
        super(new BorderLayout(0, 6));
        this.look = look;
        setName("tour");
        setOpaque(false);
        setBorder(BorderFactory.createEmptyBorder(10, 16, 14, 12));
        place = look.label("", Tone.DIM);
        title = look.label("", Tone.TEXT);
        title.setFont(look.bold(14));
        text = area("tour.text", Tone.TEXT);
        done = area("tour.done", Tone.ACCENT);
        JPanel top = new JPanel(new BorderLayout());
        top.setOpaque(false);
        top.add(place, BorderLayout.CENTER);
        FlatButton cross = new FlatButton(look, FlatButton.Style.ICON);
        cross.setIcon(Icons.CLOSE.icon(12));
        cross.setName("tour.close");
        cross.setToolTipText(look.text("tour.close"));
        cross.getAccessibleContext().setAccessibleName(look.text("tour.close"));
        cross.addActionListener(e -> close.run());
        top.add(Look.sized(cross, 24, 24), BorderLayout.EAST);
        add(top, BorderLayout.NORTH);
        JPanel words = new JPanel();
        words.setLayout(new BoxLayout(words, BoxLayout.Y_AXIS));
        words.setOpaque(false);
        for (JComponent part : new JComponent[] {title, text, done}) {
            part.setAlignmentX(LEFT_ALIGNMENT);
            words.add(part);
            words.add(Box.createVerticalStrut(look.px(5)));
        }
        add(words, BorderLayout.CENTER);
        buttons.setOpaque(false);
        add(buttons, BorderLayout.SOUTH);
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "close");
        getActionMap().put("close", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                close.run();
            }
        });
        new Dragging().attach();
    }

    private JTextArea area(String name, Tone tone) {
        JTextArea made = new JTextArea();
        made.setName(name);
        made.setFont(look.font(12.5f));
        made.setForeground(look.color(tone));
        made.setOpaque(false);
        made.setEditable(false);
        made.setFocusable(false);
        made.setLineWrap(true);
        made.setWrapStyleWord(true);
        made.setBorder(null);
        return made;
    }

    /** Shows words: where on the tour, what it is about, what to do, and what came of it, empty until it is done. */
    void show(String where, String heading, String words, String outcome) {
        place.setText(where);
        title.setText(heading);
        text.setText(words);
        done.setText(outcome.isEmpty() ? "" : "\u2713 " + outcome);
        done.setVisible(!outcome.isEmpty());
        text.getAccessibleContext().setAccessibleName(heading);
        done.getAccessibleContext().setAccessibleName(outcome);
        getAccessibleContext().setAccessibleName(where + ". " + heading);
        getAccessibleContext().setAccessibleDescription(words + " " + outcome);
    }

    /** Adds a button; an accented one is what to press next. Screen readers say the words of the card with it. */
    FlatButton button(String key, boolean accented, Runnable action) {
        FlatButton made = new FlatButton(look, accented ? FlatButton.Style.ACCENT : FlatButton.Style.PILL);
        made.setText(look.text("tour." + key));
        made.setName("tour." + key);
        made.setSelected(accented);
        made.getAccessibleContext()
                .setAccessibleDescription(getAccessibleContext().getAccessibleName() + ". "
                        + getAccessibleContext().getAccessibleDescription());
        made.addActionListener(e -> action.run());
        buttons.add(made);
        return made;
    }

    /** Returns the button that leads on, the last one. */
    FlatButton leading() {
        return (FlatButton) buttons.getComponent(buttons.getComponentCount() - 1);
    }

    /** Takes all buttons away. */
    void clearButtons() {
        buttons.removeAll();
    }

    /** Tells whether a person has put the card somewhere. */
    boolean isDragged() {
        return dragged;
    }

    /** {@inheritDoc} It is as wide as the looks say, and as high as its words need. */
    @Override
    public Dimension getPreferredSize() {
        int wide = look.px(WIDTH);
        int inner = wide - getInsets().left - getInsets().right;
        for (JTextArea area : new JTextArea[] {text, done}) {
            area.setSize(inner, Short.MAX_VALUE);
            area.setMaximumSize(new Dimension(inner, area.getPreferredSize().height));
        }
        return new Dimension(wide, super.getPreferredSize().height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        int arc = look.px(2 * ARC);
        g.setColor(look.color(Tone.PANEL));
        g.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
        g.setColor(look.color(Tone.ACCENT));
        g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
        g.dispose();
    }

    /** Moves the card with the pointer, within what it lies on. */
    private final class Dragging extends MouseAdapter {
        private Point from;

        void attach() {
            addMouseListener(this);
            addMouseMotionListener(this);
        }

        @Override
        public void mousePressed(MouseEvent event) {
            from = event.getPoint();
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            dragged = true;
            int x = getX() + event.getX() - from.x;
            int y = getY() + event.getY() - from.y;
            setLocation(
                    Math.max(0, Math.min(getParent().getWidth() - getWidth(), x)),
                    Math.max(0, Math.min(getParent().getHeight() - getHeight(), y)));
        }
    }
}
