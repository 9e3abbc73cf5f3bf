package troupe.paint.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.grid.GridFrame;
import troupe.run.view.Overlay;

/** Traces lines through fields whose lines are known. */
class ContoursTest {
    private static final GridFrame FRAME = new GridFrame(0, 0, 0.5, 41, 41);

    private static Overlay.Field cone() {
        float[] values = new float[FRAME.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) Math.hypot(FRAME.centreX(FRAME.col(i)) - 10.25, FRAME.centreY(FRAME.row(i)) - 10.25);
        }
        return field(values);
    }

    private static Overlay.Field field(float[] values) {
        return new Overlay.Field("f", 0, FRAME, values, new Overlay.Continuous("m", 0, 10, 1));
    }

    /** Returns the pieces of a path as x, y lists; a closed piece repeats its first point. */
    private static List<List<double[]>> pieces(Path2D path) {
        List<List<double[]>> pieces = new ArrayList<>();
        double[] at = new double[6];
        for (PathIterator it = path.getPathIterator(null); !it.isDone(); it.next()) {
            int kind = it.currentSegment(at);
            if (kind == PathIterator.SEG_MOVETO) {
                pieces.add(new ArrayList<>());
            }
            List<double[]> last = pieces.get(pieces.size() - 1);
            last.add(kind == PathIterator.SEG_CLOSE ? last.get(0) : new double[] {at[0], at[1]});
        }
        return pieces;
    }

    @Test
    void linesOfAConeAreClosedCircles() {
        List<List<double[]>> pieces = pieces(new Contours(cone()).lines(0, 5.5, 1));
        assertEquals(5, pieces.size());
        for (int k = 0; k < 5; k++) {
            List<double[]> circle = pieces.get(k);
            assertTrue(circle.size() > 8);
            assertEquals(circle.get(0), circle.get(circle.size() - 1), "closed");
            for (double[] p : circle) {
                assertEquals(k + 1, Math.hypot(p[0] - 10.25, p[1] - 10.25), 0.07);
            }
        }
    }

    @Test
    void noLineTouchesACellWithoutAValue() {
        Overlay.Field field = cone();
        for (int i = 0; i < field.values().length; i++) {
            if (FRAME.col(i) > 25) {
                field.values()[i] = Float.NaN;
            }
        }
        List<List<double[]>> pieces = pieces(new Contours(field).lines(0, 5.5, 1));
        assertEquals(5, pieces.size());
        assertTrue(pieces.stream().flatMap(List::stream).allMatch(p -> p[0] <= FRAME.centreX(25) + 1e-9));
        List<double[]> outer = pieces.get(4);
        assertTrue(Math.hypot(outer.get(0)[0] - outer.get(outer.size() - 1)[0], 0) < 1e-9, "both ends at the rim");
    }

    @Test
    void everyCrossedEdgeOfARandomFieldIsOnALineOnce() {
        Random random = new Random(5);
        for (int round = 0; round < 50; round++) {
            float[] values = new float[FRAME.size()];
            for (int i = 0; i < values.length; i++) {
                values[i] = random.nextInt(20) == 0 ? Float.NaN : random.nextFloat();
            }
            Path2D path = new Path2D.Double();
            new Contours(field(values)).trace(0.5, path);
            int segments = pieces(path).stream().mapToInt(p -> p.size() - 1).sum();
            assertEquals(expectedSegments(values), segments);
        }
    }

    /** Counts a segment for each square whose corners differ, two for a saddle. */
    private static int expectedSegments(float[] v) {
        int sum = 0;
        for (int row = 0; row + 1 < FRAME.rows(); row++) {
            for (int col = 0; col + 1 < FRAME.cols(); col++) {
                int i = FRAME.index(col, row);
                float[] c = {v[i], v[i + 1], v[i + FRAME.cols() + 1], v[i + FRAME.cols()]};
                int changes = 0;
                boolean whole = true;
                for (int k = 0; k < 4; k++) {
                    whole &= !Float.isNaN(c[k]);
                    changes += c[k] >= 0.5 != c[(k + 1) % 4] >= 0.5 ? 1 : 0;
                }
                sum += whole ? changes / 2 : 0;
            }
        }
        return sum;
    }
}
