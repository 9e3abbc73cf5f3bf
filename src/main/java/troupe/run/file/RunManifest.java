package troupe.run.file;

import java.util.List;
import java.util.Map;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.search.Outcome;

/** Holds what {@code run.xml} says: everything of a run but its scene and its frames, and what those must be. */
record RunManifest(
        String program,
        String task,
        long seed,
        Map<String, String> settings,
        Outcome outcome,
        Report report,
        String sceneHash,
        double rate,
        int count,
        String digest,
        List<Channel> channels,
        List<String> partHashes,
        List<Run.Leg> legs,
        List<Run.Input> inputs) {
    /** The version of the format that this program writes, and the only one that it reads. */
    static final String VERSION = "1";

    static final String NAMESPACE = "urn:troupe:run:1";

    /** Returns the name of part {@code k}: {@code frames/00000.bin}, … */
    static String partName(int k) {
        String number = Integer.toString(k);
        return "frames/" + "0".repeat(Math.max(0, 5 - number.length())) + number + ".bin";
    }
}
