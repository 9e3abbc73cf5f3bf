package troupe.app.property;

import java.util.List;
import java.util.Optional;
import troupe.scene.Scene;

/**
 * Names one thing that can be changed of an element, as a text.
 *
 * @param key the word for it in texts and in the names of fields
 * @param row the word for the row it shares with its neighbours of the same row
 * @param unit the unit, may be empty
 * @param choices what there is to choose from; empty where anything may be typed; a switch is {@link #SWITCH}
 * @param reading gives the present text, empty where the element has no such property
 * @param writing changes it
 */
public record Property(String key, String row, String unit, List<String> choices, Reading reading, Writing writing) {
    /** The choices of a property that is on or off. */
    public static final List<String> SWITCH = List.of("false", "true");

    /** Gives the present value. */
    public interface Reading {
        /** Returns the value that an element of a scene has, empty where it has no such property. */
        Optional<String> of(Scene scene, String id);
    }

    /** Changes the value. */
    public interface Writing {
        /**
         * Returns the scene with the value of one element changed.
         *
         * @throws IllegalArgumentException if the text cannot be taken, with the reason
         */
        Scene with(Scene scene, String id, String text);
    }

    /** Makes a property that is alone in its row and typed. */
    static Property typed(String key, String unit, Reading reading, Writing writing) {
        return new Property(key, key, unit, List.of(), reading, writing);
    }

    /** Tells whether the property is on or off. */
    public boolean isSwitch() {
        return choices.equals(SWITCH);
    }

    /** Returns the value that all of these elements share, of none the scene's; the empty text where theirs differ. */
    public Optional<String> common(Scene scene, List<String> ids) {
        if (ids.isEmpty()) {
            return reading.of(scene, "");
        }
        Optional<String> first = reading.of(scene, ids.get(0));
        for (String id : ids) {
            Optional<String> value = reading.of(scene, id);
            if (value.isEmpty()) {
                return Optional.empty();
            }
            first = value.equals(first) ? first : Optional.of("");
        }
        return first;
    }

    /**
     * Returns the scene with the value of all of these elements changed.
     *
     * @throws IllegalArgumentException if one of them cannot take the text
     */
    public Scene with(Scene scene, List<String> ids, String text) {
        Scene changed = ids.isEmpty() ? writing.with(scene, "", text) : scene;
        for (String id : ids) {
            changed = writing.with(changed, id, text);
        }
        return changed;
    }

    /** Returns why the elements cannot take a text, empty if they can. */
    public Optional<String> wrong(Scene scene, List<String> ids, String text) {
        try {
            with(scene, ids, text);
            return Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.of(String.valueOf(e.getMessage()));
        }
    }
}
