package troupe.scene.check;

/**
 * Names one thing that is wrong with a scene.
 *
 * @param element id of the element it concerns, empty for the scene as a whole
 * @param line line of that element in its file, from 1; 0 if there is no file
 * @param message what is wrong, with the values found
 * @param cure what to do about it
 */
public record Problem(Severity severity, String element, int line, String message, String cure) {

    /** Returns one line for a person: place, message and cure. */
    public String describe() {
        String place = (line > 0 ? "line " + line + ": " : "") + (element.isEmpty() ? "" : "'" + element + "' ");
        return place + message + (cure.isEmpty() ? "" : "; " + cure);
    }
}
