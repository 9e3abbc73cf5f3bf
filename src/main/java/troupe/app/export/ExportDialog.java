package troupe.app.export;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.event.ActionEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.Question;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.paint.Tone;
import troupe.run.Run;

/** Asks in which format the run that is shown is to be written and where to, shows a preview, and writes it. */
public final class ExportDialog {
    private final Look look;
    private final Run run;
    private final JDialog dialog;
    private final ExportWork work;
    private final ExportOptions options;
    private final PreviewPane preview;
    private final JTextField target = new JTextField();
    private final JProgressBar progress = new JProgressBar();
    private final JLabel message;
    private final FlatButton write;
    private final FlatButton close;
    private boolean writing;

    private ExportDialog(JFrame over, Look look, Run run, ExportSettings first, Path proposed, Executor eventThread) {
        this.look = look;
        this.run = run;
        this.dialog = new JDialog(over, look.text("export.title"), true);
        this.work = new ExportWork(eventThread);
        this.options = new ExportOptions(look, first, run.frames().duration(), this::chosen);
        this.preview = new PreviewPane(look);
        this.message = look.label(" ", Tone.DIM);
        this.write = button("export.write", FlatButton.Style.ACCENT, this::write);
        this.close = button("export.close", FlatButton.Style.PILL, this::leave);
        write.setSelected(true);
        target.setName("export.target");
        target.setFont(look.font());
        target.setText(proposed.toString());
        target.getAccessibleContext().setAccessibleName(look.text("export.target"));
        progress.setName("export.progress");
        progress.setVisible(false);
        message.setName("export.message");
        build();
    }

    /**
     * Shows the dialog until it is closed.
     *
     * @param first settings to begin with
     * @param proposed the file to propose, without an ending
     */
    public static void show(
            JFrame over, Look look, Run run, ExportSettings first, Path proposed, Executor eventThread) {
        ExportDialog made = new ExportDialog(over, look, run, first, proposed, eventThread);
        made.chosen();
        made.dialog.setVisible(true);
    }

    private void build() {
        dialog.setName("export");
        JPanel all = new JPanel(new BorderLayout(18, 14));
        all.setBackground(look.color(Tone.PANEL));
        all.setBorder(BorderFactory.createEmptyBorder(18, 20, 16, 20));
        all.add(options.panel(), BorderLayout.WEST);
        all.add(preview, BorderLayout.CENTER);
        JPanel file = new JPanel(new BorderLayout(8, 0));
        file.setOpaque(false);
        file.add(look.label(look.text("export.target"), Tone.DIM), BorderLayout.WEST);
        file.add(target, BorderLayout.CENTER);
        file.add(button("export.choose", FlatButton.Style.PILL, this::choose), BorderLayout.EAST);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 8, 0));
        buttons.setOpaque(false);
        buttons.add(close);
        buttons.add(write);
        JPanel state = new JPanel(new BorderLayout(10, 0));
        state.setOpaque(false);
        state.add(message, BorderLayout.CENTER);
        state.add(Look.sized(progress, 130, 8), BorderLayout.EAST);
        JPanel last = new JPanel(new BorderLayout(12, 0));
        last.setOpaque(false);
        last.add(state, BorderLayout.CENTER);
        last.add(buttons, BorderLayout.EAST);
        JPanel below = new JPanel(new BorderLayout(0, 12));
        below.setOpaque(false);
        below.add(file, BorderLayout.NORTH);
        below.add(last, BorderLayout.SOUTH);
        all.add(below, BorderLayout.SOUTH);
        dialog.setContentPane(new Scaling(look::scale).apply(all));
        dialog.getRootPane()
                .getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                .put(KeyStroke.getKeyStroke("ESCAPE"), "leave");
        dialog.getRootPane().getActionMap().put("leave", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                leave();
            }
        });
        dialog.setDefaultCloseOperation(JDialog.DO_NOTHING_ON_CLOSE);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                leave();
            }
        });
        dialog.setSize(new Dimension(look.px(860), look.px(520)));
        dialog.setMinimumSize(new Dimension(look.px(700), look.px(460)));
        dialog.setLocationRelativeTo(dialog.getOwner());
    }

    private FlatButton button(String key, FlatButton.Style style, Runnable action) {
        FlatButton button = new FlatButton(look, style);
        button.setText(look.text(key));
        button.setName(key);
        button.addActionListener(e -> {
            button.setSelected(style == FlatButton.Style.ACCENT);
            action.run();
        });
        return button;
    }

    /** Takes what was chosen: the ending of the file, and a preview. */
    private void chosen() {
        Exporter exporter = options.exporter();
        String name = target.getText();
        int dot = name.lastIndexOf('.');
        boolean known = dot > Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) && name.length() - dot <= 8;
        target.setText((known ? name.substring(0, dot) : name) + "." + exporter.extension());
        message.setText(" ");
        preview.waiting();
        work.preview(exporter, run, options.settings(), preview::show);
    }

    private void choose() {
        JFileChooser chooser = new JFileChooser();
        file().map(Path::toFile).ifPresent(chooser::setSelectedFile);
        if (chooser.showSaveDialog(dialog) == JFileChooser.APPROVE_OPTION) {
            target.setText(chooser.getSelectedFile().toString());
        }
    }

    private Optional<Path> file() {
        try {
            return target.getText().isBlank()
                    ? Optional.empty()
                    : Optional.of(Path.of(target.getText().strip()));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    private void write() {
        Path file = file().orElse(null);
        if (writing || file == null) {
            say("export.nofile", Tone.MOVE);
            return;
        }
        if (Files.isDirectory(file)) {
            say("export.folder", Tone.MOVE);
            return;
        }
        if (Files.exists(file)
                && new Question(look, "export.replace")
                        .ask(dialog, look.texts().format("file.replace", file.getFileName()), List.of("yes", "no"))
                        .filter("yes"::equals)
                        .isEmpty()) {
            return;
        }
        begin(file);
    }

    private void begin(Path file) {
        writing = true;
        write.setEnabled(false);
        close.setText(look.text("export.cancel"));
        progress.setMaximum(options.pictures());
        progress.setIndeterminate(options.pictures() <= 1);
        progress.setVisible(true);
        say("export.writing", Tone.DIM);
        work.write(options.exporter(), run, options.settings(), file, progress::setValue, result -> {
            writing = false;
            write.setEnabled(true);
            close.setText(look.text("export.close"));
            progress.setVisible(false);
            if (result.done()) {
                message.setForeground(look.color(Tone.TEXT));
                message.setText(look.texts().format("export.done", file.getFileName()));
                message.setToolTipText(file.toAbsolutePath().toString());
            } else if (result.wrong().isPresent()) {
                message.setForeground(look.color(Tone.MOVE));
                String wrong = look.texts().tell(result.wrong().get());
                message.setText(wrong);
                message.setToolTipText(wrong);
            } else {
                say("export.cancelled", Tone.DIM);
            }
        });
    }

    private void say(String key, Tone tone) {
        message.setForeground(look.color(tone));
        message.setText(look.text(key));
    }

    /** Cancels what is being written, or closes the dialog. */
    private void leave() {
        if (writing) {
            work.cancel();
        } else {
            work.close();
            dialog.dispose();
        }
    }
}
