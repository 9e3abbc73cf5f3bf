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
import troupe.app.look.Texts;
import troupe.app.look.widget.Question;
import troupe.app.recovery.KeptFiles;
import troupe.app.recovery.Recovery;
import troupe.app.session.Notice;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.frame.Frames;

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

    /** Asks whether to show a simulation that was cut off, and does what is answered. */
    static void ask(StudioWindow window, Recovery recovery, Recovery.RunOffer offer) {
        Look look = window.look();
        Frames frames = offer.run().frames();
        Optional<String> answer = new Question(look, "recovery.run")
                .ask(window.frame(), content(look, offer), List.of("restore", "later", "discard"));
        if (answer.equals(Optional.of("restore"))) {
            String told = look.texts().format("recovery.run.done", frames.count());
            Session session = window.session();
            new FileDialogs(window.frame(), session, look)
                    .unlessUnsaved(() ->
                            recovery.bringBack(offer, () -> session.notices().tell(new Notice(false, told))));
        } else if (answer.equals(Optional.of("discard"))) {
            recovery.discard(offer);
        }
    }

    private static JPanel content(Look look, Recovery.RunOffer offer) {
        String title = offer.run().scene().title();
        JPanel words = words(look, title.isEmpty() ? look.text("file.untitled") : title);
        Frames frames = offer.run().frames();
        String seconds = Texts.number(frames.duration(), 1);
        String time = time(look, offer.left());
        words.add(look.label(look.texts().format("recovery.run", frames.count(), seconds, time), Tone.TEXT));
        words.add(Box.createVerticalStrut(4));
        words.add(look.label(look.text("recovery.run.hint"), Tone.DIM));
        return words;
    }

    private static JPanel words(Look look, String title) {
        JPanel words = new JPanel();
        words.setLayout(new BoxLayout(words, BoxLayout.Y_AXIS));
        words.setOpaque(false);
        JLabel name = look.label(title, Tone.TEXT);
        name.setFont(look.bold(14));
        words.add(name);
        words.add(Box.createVerticalStrut(4));
        return words;
    }

    private static JPanel content(Look look, Recovery.Offer offer) {
        String title = offer.scene().title().isEmpty()
                ? look.text("file.untitled")
                : offer.scene().title();
        JPanel words = words(
                look, offer.left().file().map(f -> f.getFileName().toString()).orElse(title));
        words.add(look.label(
                offer.left().file().map(Path::getParent).map(Path::toString).orElse(" "), Tone.DIM));
        words.add(Box.createVerticalStrut(12));
        words.add(look.label(look.texts().format("recovery", time(look, offer.left())), Tone.TEXT));
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

    private static String time(Look look, KeptFiles.Left left) {
        return DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM, FormatStyle.SHORT)
                .withLocale(look.texts().locale())
                .format(ZonedDateTime.ofInstant(left.time(), ZoneId.systemDefault()));
    }
}
