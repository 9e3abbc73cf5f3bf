package troupe.app;

import java.awt.BorderLayout;
import java.nio.file.Path;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.List;
import java.util.Optional;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.ImageIcon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import troupe.app.look.Look;
import troupe.app.look.widget.Question;
import troupe.app.recovery.Recovery;
import troupe.paint.Tone;

/** Asks whether to bring back edits that were not saved before the studio ended, with their picture and time. */
final class RecoveryQuestion {
    private RecoveryQuestion() {}

    /** Asks, and does what is answered; without an answer the edits are offered again another time. */
    static void ask(StudioWindow window, Recovery recovery, Recovery.Offer offer) {
        Look look = window.look();
        Optional<String> answer = new Question(look, "recovery")
                .ask(window.frame(), content(look, offer), List.of("restore", "later", "discard"));
        if (answer.equals(Optional.of("restore"))) {
            new FileDialogs(window.frame(), window.session(), look)
                    .unlessUnsaved(() -> recovery.bringBack(offer, look.text("edit.recovered")));
        } else if (answer.equals(Optional.of("discard"))) {
            recovery.discard(offer);
        }
    }

    private static JPanel content(Look look, Recovery.Offer offer) {
        JPanel words = new JPanel();
        words.setLayout(new BoxLayout(words, BoxLayout.Y_AXIS));
        words.setOpaque(false);
        String title = offer.scene().title().isEmpty()
                ? look.text("file.untitled")
                : offer.scene().title();
        JLabel name = look.label(
                offer.left().file().map(f -> f.getFileName().toString()).orElse(title), Tone.TEXT);
        name.setFont(look.bold(14));
        words.add(name);
        words.add(Box.createVerticalStrut(4));
        words.add(look.label(
                offer.left().file().map(Path::getParent).map(Path::toString).orElse(" "), Tone.DIM));
        words.add(Box.createVerticalStrut(12));
        words.add(look.label(look.texts().format("recovery", time(look, offer)), Tone.TEXT));
        words.add(Box.createVerticalStrut(4));
        words.add(look.label(look.text("recovery.hint"), Tone.DIM));
        JLabel picture = new JLabel(new ImageIcon(offer.picture()));
        picture.getAccessibleContext().setAccessibleName(look.text("recovery.picture"));
        picture.setBorder(look.line(1, 1, 1, 1));
        JPanel all = new JPanel(new BorderLayout(18, 0));
        all.setOpaque(false);
        all.add(picture, BorderLayout.WEST);
        all.add(words, BorderLayout.CENTER);
        return all;
    }

    private static String time(Look look, Recovery.Offer offer) {
        return DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM, FormatStyle.SHORT)
                .withLocale(look.texts().locale())
                .format(ZonedDateTime.ofInstant(offer.left().time(), ZoneId.systemDefault()));
    }
}
