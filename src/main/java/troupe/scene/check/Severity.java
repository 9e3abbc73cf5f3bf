package troupe.scene.check;

/** Says how bad a problem of a scene is; worst first. */
public enum Severity {
    /** The scene cannot be planned as it is. */
    ERROR,
    /** The scene can be planned, but something in it is probably not meant. */
    WARNING
}
