package troupe.risk.forecast;

import java.util.Arrays;
import troupe.grid.GridFrame;

/**
 * Spreads the place of one avatar over the cells of the ground: Avatars, equation 4 and figure 4. What it cannot
 * reach is clipped, and the rest scaled so that density times area adds up to one.
 */
public final class ProbabilityMap {
    private final Forecast forecast;
    private final Ways ways;

    /** Makes maps of a forecast over the same ground. */
    public ProbabilityMap(Forecast forecast, Ways ways) {
        this.forecast = forecast;
        this.ways = ways;
    }

    /**
     * Adds the density of an avatar at a time to those in an array.
     *
     * @param seconds from now, from 0 to the horizon
     * @param density one value for each cell of the ground, per square metre
     */
    public void add(int avatar, double seconds, float[] density) {
        double middleX = forecast.expectedX(avatar, seconds);
        double middleY = forecast.expectedY(avatar, seconds);
        double sigma = forecast.sigma(avatar, seconds);
        Reach reach = forecast.reach(avatar);
        GridFrame frame = ways.frame();
        double far = 5 * Math.max(sigma, frame.cell());
        double[] bell = new double[frame.size()];
        double sum = 0;
        for (int row = Math.max(0, frame.rowAt(middleY - far));
                row <= Math.min(frame.rows() - 1, frame.rowAt(middleY + far));
                row++) {
            for (int col = Math.max(0, frame.colAt(middleX - far));
                    col <= Math.min(frame.cols() - 1, frame.colAt(middleX + far));
                    col++) {
                int cell = frame.index(col, row);
                double dx = frame.centreX(col) - middleX;
                double dy = frame.centreY(row) - middleY;
                if (reach.reaches(frame.centreX(col), frame.centreY(row), seconds)) {
                    bell[cell] = StrictMath.exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
                    sum += bell[cell];
                }
            }
        }
        if (!(sum > 0)) {
            Arrays.fill(bell, 0);
            int block = reach.nearest(middleX, middleY, seconds);
            int cell = block < 0
                    ? frame.cellAt(forecast.expectedX(avatar, 0), forecast.expectedY(avatar, 0))
                    : frame.cellAt(ways.standX(block), ways.standY(block));
            if (cell < 0) {
                return;
            }
            bell[cell] = 1;
            sum = 1;
        }
        double scale = 1 / (sum * frame.cell() * frame.cell());
        for (int cell = 0; cell < bell.length; cell++) {
            density[cell] += (float) (bell[cell] * scale);
        }
    }
}
