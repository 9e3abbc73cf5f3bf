package troupe.scene.xml;

import static troupe.scene.Numbers.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.StringTokenizer;
import java.util.function.Function;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Numbers;
import troupe.scene.Place;
import troupe.scene.setting.SettingTable;

/**
 * Collects an encounter while its elements are read, and tells its attributes for the writer. An attribute is
 * asked for by name and is null where it is absent.
 */
final class EncounterForm {
    /** The most recorded positions of one encounter. */
    private static final int MAX_FIXES = 1_000_000;

    private Encounter encounter;
    private final List<Avatar> avatars = new ArrayList<>();
    private final Optional<Path> folder;
    private Avatar avatar;
    private List<Avatar.Head> heads;
    private int fixes;

    /**
     * Begins with the attributes of the encounter itself.
     *
     * @param folder where files of tracks are looked for, empty if the scene is no file
     */
    EncounterForm(String id, Function<String, String> a, Optional<Path> folder) {
        this.folder = folder;
        Map<Encounter.Quantity, Double> numbers = new EnumMap<>(Encounter.Quantity.class);
        for (Encounter.Quantity quantity : Encounter.Quantity.values()) {
            if (a.apply(quantity.key()) != null) {
                numbers.put(quantity, number(a, quantity.key(), 0));
            }
        }
        encounter = new Encounter(
                id,
                or(a.apply("label"), ""),
                or(a.apply("actor"), ""),
                Numbers.place(or(a.apply("start"), "")),
                Numbers.place(or(a.apply("goal"), "")),
                List.of(),
                word(a, "method", Encounter.Method.RISK),
                word(a, "ordering", Encounter.Order.PAPER),
                word(a, "influence", Encounter.Influence.EXPECTED),
                word(a, "growth", Encounter.Growth.LINEAR),
                numbers,
                a.apply("seed") == null ? 1 : Numbers.whole(a.apply("seed")));
    }

    /** Begins an avatar; {@link #endAvatar} ends it. */
    void startAvatar(String id, Function<String, String> a) {
        heads = new ArrayList<>();
        avatar = null;
        Avatar.Motion motion = new Avatar.Recording(List.of());
        if (a.apply("start") != null) {
            Place start = Numbers.place(a.apply("start"));
            motion = a.apply("pace") == null
                    ? new Avatar.Pointer(start)
                    : new Avatar.Script(start, number(a, "pace", Avatar.DEFAULT_PACE), List.of());
        }
        avatar = body(id, a, motion);
    }

    private static Avatar body(String id, Function<String, String> a, Avatar.Motion motion) {
        return new Avatar(
                id,
                or(a.apply("label"), ""),
                or(a.apply("colour"), ""),
                number(a, "radius", Avatar.DEFAULT_RADIUS),
                number(a, "speed", Avatar.DEFAULT_SPEED),
                number(a, "mobility", Avatar.DEFAULT_MOBILITY),
                word(a, "kind", Avatar.Kind.UNCERTAIN),
                motion);
    }

    /** Adds a goal of the avatar's script. */
    void head(Function<String, String> a) {
        if (avatar == null) {
            return;
        }
        OptionalDouble at = a.apply("at") == null ? OptionalDouble.empty() : OptionalDouble.of(number(a, "at", 0));
        heads.add(new Avatar.Head(Numbers.place(or(a.apply("to"), "")), at));
    }

    /** Gives the avatar its recorded positions, {@code t,x,y t,x,y …}. */
    void track(Function<String, String> a) {
        if (avatar == null) {
            return;
        }
        if (!(avatar.motion() instanceof Avatar.Recording)) {
            throw new IllegalArgumentException("an avatar with a start cannot have a track; take one of the two away");
        }
        List<Avatar.Fix> all = new ArrayList<>();
        StringTokenizer words = new StringTokenizer(or(a.apply("points"), ""));
        while (words.hasMoreTokens()) {
            String[] parts = words.nextToken().split(",", -1);
            if (parts.length != 3) {
                throw new IllegalArgumentException("points: t,x,y is expected, " + parts.length + " numbers found");
            }
            all.add(new Avatar.Fix(Numbers.number(parts[0]), Numbers.number(parts[1]), Numbers.number(parts[2])));
        }
        count(all.size());
        avatar = moving(new Avatar.Recording(all));
    }

    private void count(int more) {
        fixes += more;
        if (fixes > MAX_FIXES) {
            throw new IllegalArgumentException("more than " + MAX_FIXES + " recorded positions; leave some out");
        }
    }

    private Avatar moving(Avatar.Motion motion) {
        return new Avatar(
                avatar.id(),
                avatar.label(),
                avatar.colour(),
                avatar.radius(),
                avatar.speed(),
                avatar.mobility(),
                avatar.kind(),
                motion);
    }

    /** Ends the avatar; of one that could not be read nothing is kept. */
    void endAvatar() {
        if (avatar == null) {
            return;
        }
        if (!heads.isEmpty()) {
            if (avatar.motion() instanceof Avatar.Pointer pointer) {
                avatar = moving(new Avatar.Script(pointer.start(), Avatar.DEFAULT_PACE, heads));
            } else if (avatar.motion() instanceof Avatar.Script script) {
                avatar = moving(new Avatar.Script(script.start(), script.pace(), heads));
            } else {
                throw new IllegalArgumentException("avatar '" + avatar.id() + "' has goals and no start");
            }
        }
        avatars.add(avatar);
    }

    /** Adds an avatar for each person of a file of tracks that is there at or after {@code begin} seconds. */
    void tracks(Function<String, String> a) throws SceneException {
        String file = or(a.apply("file"), "");
        if (folder.isEmpty()) {
            throw new IllegalArgumentException("file: a scene that is no file has no folder to find '" + file + "' in");
        }
        if (file.contains("/") || file.contains("\\") || file.contains("..") || file.isBlank()) {
            throw new IllegalArgumentException("file: '" + file + "' is not the plain name of a file beside the scene");
        }
        OptionalDouble rate =
                a.apply("rate") == null ? OptionalDouble.empty() : OptionalDouble.of(number(a, "rate", 0));
        double begin = number(a, "begin", 0);
        String prefix = or(a.apply("prefix"), "p");
        Path path = folder.get().resolve(file);
        try (InputStream in = Files.newInputStream(path)) {
            for (TrackTable.Person person :
                    TrackTable.read(in, path.toString(), rate).people()) {
                List<Avatar.Fix> later = person.fixes().stream()
                        .map(fix -> new Avatar.Fix(fix.time() - begin, fix.x(), fix.y()))
                        .toList();
                if (later.get(later.size() - 1).time() >= 0) {
                    count(later.size());
                    avatars.add(body(prefix + person.id(), a, new Avatar.Recording(later)));
                }
            }
        } catch (IOException e) {
            throw new IllegalArgumentException("file: '" + path + "' cannot be read", e);
        }
    }

    /** Returns the encounter as read. */
    Encounter encounter() {
        return encounter.among(avatars);
    }

    private static String or(String value, String absent) {
        return value == null ? absent : value;
    }

    private static double number(Function<String, String> a, String name, double absent) {
        try {
            return a.apply(name) == null ? absent : Numbers.number(a.apply(name));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
        }
    }

    private static <E extends Enum<E>> E word(Function<String, String> a, String name, E absent) {
        String value = or(a.apply(name), "").strip();
        for (E constant : absent.getDeclaringClass().getEnumConstants()) {
            if (word(constant).equals(value)) {
                return constant;
            }
        }
        return absent;
    }

    /** Returns the word for a constant in files. */
    static String word(Enum<?> constant) {
        return SettingTable.word(constant);
    }

    /** Receives an attribute: its name, its value, and the value that absence stands for. */
    interface Attributes {
        void put(String name, String value, String absent);
    }

    /** Hands out the attributes of an encounter, those of its name apart. */
    static void attributes(Encounter e, Attributes out) {
        out.put("actor", e.actor(), "");
        out.put("start", text(e.start()), "");
        out.put("goal", text(e.goal()), "");
        out.put("method", word(e.method()), word(Encounter.Method.RISK));
        out.put("ordering", word(e.ordering()), word(Encounter.Order.PAPER));
        out.put("influence", word(e.influence()), word(Encounter.Influence.EXPECTED));
        out.put("growth", word(e.growth()), word(Encounter.Growth.LINEAR));
        for (Encounter.Quantity quantity : Encounter.Quantity.values()) {
            out.put(quantity.key(), text(e.number(quantity)), text(quantity.usual()));
        }
        out.put("seed", Long.toString(e.seed()), "1");
    }

    /** Hands out the attributes of an avatar. */
    static void attributes(Avatar avatar, Attributes out) {
        out.put("id", avatar.id(), null);
        out.put("label", avatar.label(), "");
        out.put("colour", avatar.colour(), "");
        out.put("radius", text(avatar.radius()), text(Avatar.DEFAULT_RADIUS));
        out.put("speed", text(avatar.speed()), text(Avatar.DEFAULT_SPEED));
        out.put("mobility", text(avatar.mobility()), text(Avatar.DEFAULT_MOBILITY));
        out.put("kind", word(avatar.kind()), word(Avatar.Kind.UNCERTAIN));
        if (avatar.motion() instanceof Avatar.Pointer pointer) {
            out.put("start", text(pointer.start()), "");
        } else if (avatar.motion() instanceof Avatar.Script script) {
            out.put("start", text(script.start()), "");
            // a script without goals is told from a pointer by its pace
            out.put("pace", text(script.pace()), script.heads().isEmpty() ? "" : text(Avatar.DEFAULT_PACE));
        }
    }

    /** Returns recorded positions as they stand in files. */
    static String points(Avatar.Recording recording) {
        StringBuilder points = new StringBuilder();
        for (Avatar.Fix fix : recording.fixes()) {
            points.append(points.length() == 0 ? "" : " ")
                    .append(text(fix.time()))
                    .append(',')
                    .append(text(fix.x()))
                    .append(',')
                    .append(text(fix.y()));
        }
        return points.toString();
    }
}
