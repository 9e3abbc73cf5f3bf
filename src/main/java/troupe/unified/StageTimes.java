package troupe.unified;

import troupe.run.Report;

/** Adds up the wall time of the paper's stages. It takes no part in any result. */
final class StageTimes {
    static final int LAYERS = 0;
    static final int REGION = 1;
    static final int NF2 = 2;
    static final int INSTANCES = 3;
    static final int SEARCH = 4;

    private static final String[] NAMES = {"layers", "region", "nf2", "instances", "search"};

    private final long[] nanos = new long[NAMES.length];

    /** Does some work and adds its time to a stage. */
    void measure(int stage, Runnable work) {
        long begin = System.nanoTime();
        work.run();
        nanos[stage] += System.nanoTime() - begin;
    }

    /** Returns the milliseconds of each stage. */
    Report report() {
        Report.Builder report = Report.builder();
        for (int i = 0; i < NAMES.length; i++) {
            report.put(NAMES[i], nanos[i] / 1e6);
        }
        return report.build();
    }
}
