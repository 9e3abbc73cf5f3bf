package troupe.app;

import java.awt.EventQueue;
import java.awt.Point;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import javax.swing.Timer;
import troupe.app.document.SceneDocument;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.paint.Viewport;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/**
 * Runs a studio in a process of its own, to be killed. Given a scene file, a folder for recovery and places in
 * metres, prints where on the screen these places are, once there is a plan.
 */
final class DoomedStudio {
    private DoomedStudio() {}

    public static void main(String[] arguments) throws Exception {
        Path file = Path.of(arguments[0]);
        Scene scene = SceneXml.read(file).scene();
        Map<String, String> settings = new HashMap<>(Map.of("language", "en", "recovery", arguments[1]));
        EventQueue.invokeLater(() -> {
            Session session = new Session(
                    new SceneDocument(scene, Optional.of(file)),
                    new Studio.Steps(),
                    Studio.FILES,
                    EventQueue::invokeLater);
            StudioWindow window = new StudioWindow(
                    session, new StudioSettings(settings::getOrDefault, settings::put), EventQueue::invokeLater);
            window.open();
            session.planNow();
            Timer timer = new Timer(50, null);
            timer.addActionListener(e -> {
                if (window.canvas().isShowing() && session.plan().isPresent()) {
                    timer.stop();
                    tell(window, arguments);
                }
            });
            timer.start();
        });
    }

    private static void tell(StudioWindow window, String[] arguments) {
        Viewport view = window.canvas().view();
        Point corner = window.canvas().getLocationOnScreen();
        StringBuilder line = new StringBuilder();
        for (int i = 2; i + 1 < arguments.length; i += 2) {
            line.append(corner.x + Math.round(view.px(Double.parseDouble(arguments[i]))))
                    .append(' ')
                    .append(corner.y + Math.round(view.py(Double.parseDouble(arguments[i + 1]))))
                    .append(' ');
        }
        System.out.println(line.toString().strip());
    }
}
