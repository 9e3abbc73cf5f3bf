package troupe.bench;

import java.util.Arrays;

/**
 * Moves points by separation, cohesion and alignment alone, over plain arrays and a sorted cell list: no walls, no
 * bodies, no kinship, nobody keeps clear of anybody. It is the floor below which a crowd cannot come.
 */
final class PlainFlock {
    private final int count;
    private final double view;
    private final double size;
    private final int cols;
    private final int[] starts;
    private double[] x;
    private double[] y;
    private double[] hx;
    private double[] hy;
    private double[] nextX;
    private double[] nextY;
    private double[] nextHx;
    private double[] nextHy;
    private long visits;
    private long moves;

    PlainFlock(double[] atX, double[] atY, double size, double view) {
        this.count = atX.length;
        this.size = size;
        this.view = view;
        this.cols = (int) (size / (view / 2)) + 1;
        this.starts = new int[cols * cols + 1];
        x = atX.clone();
        y = atY.clone();
        hx = new double[count];
        hy = new double[count];
        for (int i = 0; i < count; i++) {
            hx[i] = Math.cos(i);
            hy[i] = Math.sin(i);
        }
        nextX = new double[count];
        nextY = new double[count];
        nextHx = new double[count];
        nextHy = new double[count];
    }

    double visitsPerMove() {
        return (double) visits / moves;
    }

    void run(int steps) {
        for (int step = 0; step < steps; step++) {
            sort();
            for (int i = 0; i < count; i++) {
                move(i);
            }
            swap();
        }
    }

    private int cell(double v) {
        return Math.max(0, Math.min(cols - 1, (int) (v / (view / 2))));
    }

    private void sort() {
        Arrays.fill(starts, 0);
        for (int i = 0; i < count; i++) {
            starts[cell(y[i]) * cols + cell(x[i]) + 1]++;
        }
        for (int c = 1; c < starts.length; c++) {
            starts[c] += starts[c - 1];
        }
        for (int i = 0; i < count; i++) {
            int place = starts[cell(y[i]) * cols + cell(x[i])]++;
            nextX[place] = x[i];
            nextY[place] = y[i];
            nextHx[place] = hx[i];
            nextHy[place] = hy[i];
        }
        System.arraycopy(starts, 0, starts, 1, starts.length - 1);
        starts[0] = 0;
        swap();
    }

    private void swap() {
        double[] keep = x;
        x = nextX;
        nextX = keep;
        keep = y;
        y = nextY;
        nextY = keep;
        keep = hx;
        hx = nextHx;
        nextHx = keep;
        keep = hy;
        hy = nextHy;
        nextHy = keep;
    }

    private void move(int i) {
        double pushX = 0;
        double pushY = 0;
        double midX = 0;
        double midY = 0;
        double alongX = 0;
        double alongY = 0;
        int seen = 0;
        int right = Math.min(cols - 1, cell(x[i]) + 2);
        int left = Math.max(0, cell(x[i]) - 2);
        int high = Math.min(cols - 1, cell(y[i]) + 2);
        for (int row = Math.max(0, cell(y[i]) - 2); row <= high; row++) {
            int end = starts[row * cols + right + 1];
            for (int j = starts[row * cols + left]; j < end; j++) {
                visits++;
                double dx = x[j] - x[i];
                double dy = y[j] - y[i];
                double squared = dx * dx + dy * dy;
                if (squared < view * view && j != i) {
                    double push = 0.05 / Math.max(1e-6, squared * Math.sqrt(squared));
                    pushX -= push * dx;
                    pushY -= push * dy;
                    midX += dx;
                    midY += dy;
                    alongX += hx[j];
                    alongY += hy[j];
                    seen++;
                }
            }
        }
        double n = Math.max(1, seen);
        double sumX = hx[i] + pushX + 0.4 * midX / n / view + 0.4 * alongX / n;
        double sumY = hy[i] + pushY + 0.4 * midY / n / view + 0.4 * alongY / n;
        double length = Math.max(1e-9, Math.sqrt(sumX * sumX + sumY * sumY));
        nextHx[i] = sumX / length;
        nextHy[i] = sumY / length;
        nextX[i] = wrapped(x[i] + nextHx[i] * 0.052);
        nextY[i] = wrapped(y[i] + nextHy[i] * 0.052);
        moves++;
    }

    private double wrapped(double v) {
        return v < 0 ? v + size : v >= size ? v - size : v;
    }
}
