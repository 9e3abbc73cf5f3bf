package troupe.app.document;

/**
 * Names a state of the document: the number of changes since it was opened, and the number of
 * previews of the gesture that is under way, 0 when none is. Results are matched to states by it.
 */
public record Version(long revision, long preview) implements Comparable<Version> {

    @Override
    public int compareTo(Version other) {
        int order = Long.compare(revision, other.revision);
        return order != 0 ? order : Long.compare(preview, other.preview);
    }
}
