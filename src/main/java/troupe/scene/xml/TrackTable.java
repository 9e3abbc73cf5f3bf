package troupe.scene.xml;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import troupe.scene.Avatar;
import troupe.scene.Numbers;
import troupe.scene.check.SceneChecks;

/**
 * Reads recorded positions from a CSV file {@code frame,id,x,y}: metres, one row for each person and frame, rows
 * of one person in the order of frames, persons numbered by whole numbers. Lines that begin with {@code #} are
 * remarks; one that reads {@code # fps=25} tells the frames per second. Immutable.
 */
public final class TrackTable {
    /** The largest file that is read, in bytes. */
    public static final int MAX_BYTES = 64 << 20;

    private static final Pattern FPS = Pattern.compile("#\\s*fps\\s*=\\s*(\\S+)\\s*");

    /** The track of one person: its number in the file, and where it was, in the order of time. */
    public record Person(long id, List<Avatar.Fix> fixes) {

        /** Copies the list. */
        public Person {
            fixes = List.copyOf(fixes);
        }
    }

    private final List<Person> people;

    private TrackTable(List<Person> people) {
        this.people = List.copyOf(people);
    }

    /** Returns the people in the order of their numbers. */
    public List<Person> people() {
        return people;
    }

    /**
     * Reads a table from a stream, which stays open. Cost O(size).
     *
     * @param name what to call it in messages
     * @param rate frames per second; where it is empty the file must tell
     * @throws SceneException if it is not such a table, with the line
     * @throws IOException if it cannot be read
     */
    public static TrackTable read(InputStream in, String name, OptionalDouble rate) throws SceneException, IOException {
        byte[] bytes = in.readNBytes(MAX_BYTES + 1);
        if (bytes.length > MAX_BYTES) {
            throw new SceneException(name, 0, "more than " + MAX_BYTES + " bytes", "split the file");
        }
        String text;
        try {
            text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(java.nio.ByteBuffer.wrap(bytes))
                    .toString();
        } catch (CharacterCodingException e) {
            throw new SceneException(name, 1, "this is not a text in UTF-8", "give a CSV file frame,id,x,y");
        }
        return new TrackTable(new Reading(name, rate).people(text.split("\\R", -1)));
    }

    /** Reads the lines of one file. */
    private static final class Reading {
        private final String name;
        private double rate;
        private int line;

        Reading(String name, OptionalDouble rate) {
            this.name = name;
            this.rate = rate.orElse(0);
        }

        List<Person> people(String[] lines) throws SceneException {
            Map<Long, List<Avatar.Fix>> tracks = new TreeMap<>();
            boolean headed = false;
            for (String text : lines) {
                line++;
                Matcher fps = FPS.matcher(text);
                if (fps.matches() && rate == 0) {
                    rate = number(fps.group(1));
                }
                if (text.isBlank() || text.startsWith("#")) {
                    continue;
                }
                if (!headed && text.strip().equals("frame,id,x,y")) {
                    headed = true;
                    continue;
                }
                row(text, tracks);
            }
            List<Person> people = new ArrayList<>();
            tracks.forEach((id, fixes) -> people.add(new Person(id, fixes)));
            return people;
        }

        private void row(String text, Map<Long, List<Avatar.Fix>> tracks) throws SceneException {
            String[] words = text.split(",", -1);
            if (words.length != 4) {
                throw mistake(words.length + " values where frame,id,x,y is expected");
            }
            if (!(rate > 0 && rate <= 1000)) {
                throw new SceneException(
                        name,
                        line,
                        "the frames per second are not known, or not above 0 and at most 1000",
                        "write '# fps=25' before the rows, or give the rate");
            }
            double time = number(words[0]) / rate;
            double x = number(words[2]);
            double y = number(words[3]);
            if (!Double.isFinite(time)
                    || Math.abs(x) > SceneChecks.LARGEST
                    || Math.abs(y) > SceneChecks.LARGEST
                    || !Double.isFinite(x + y)) {
                throw mistake("a number that is not finite or too large");
            }
            double id = number(words[1]);
            if (id != Math.rint(id) || Math.abs(id) > 1e15) {
                throw mistake("'" + words[1] + "' where the whole number of a person is expected");
            }
            List<Avatar.Fix> track = tracks.computeIfAbsent((long) id, key -> new ArrayList<>());
            if (!track.isEmpty() && track.get(track.size() - 1).time() >= time) {
                throw mistake("person " + (long) id + " is in a frame that is not later than the one before");
            }
            track.add(new Avatar.Fix(time, x, y));
        }

        private double number(String word) throws SceneException {
            try {
                return Numbers.number(word);
            } catch (IllegalArgumentException e) {
                throw mistake(e.getMessage());
            }
        }

        private SceneException mistake(String message) {
            return new SceneException(name, line, message, "give rows frame,id,x,y");
        }
    }
}
