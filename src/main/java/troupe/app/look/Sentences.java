package troupe.app.look;

import java.text.MessageFormat;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Tells sentences of the library (problems of scenes, reasons why there is no way) in another language. The library
 * speaks English and knows no languages, and reasons are also read from files; so each sentence is found again by its
 * words: the English texts under {@code sentence.} are patterns with places for values, of which the one with the
 * most words of its own that fits is taken; values that are themselves such sentences are told, too. What is not
 * known is left as it is. Immutable; safe on any thread.
 */
final class Sentences {
    /** What the keys of the patterns begin with. */
    static final String PREFIX = "sentence.";

    private static final Pattern PLACE = Pattern.compile("\\{(\\d)}");
    private static final Pattern NAMED_NUMBER = Pattern.compile("([A-Za-z][\\w.]*) (-?[\\d.eE]+)");
    private static final Pattern WORD = Pattern.compile("[a-z]{3,}");
    private static final Pattern VERBATIM = Pattern.compile("[</\"=]");
    private static final int FEW = 10;
    private static final List<String> JOINTS = List.of("; ", ": ");

    private final List<Rule> rules;
    private final Function<String, Optional<String>> names;

    /** Where a value stands: its number, whether it is a name in quotes, and whether it is a word of files to be left. */
    private record Place(int number, boolean quoted, boolean verbatim) {}

    /** A sentence: what it looks like in English, which value stands where, and how it is told. */
    private record Rule(Pattern english, List<Place> places, String told, int length) {
        /**
         * Tells whether a value that is not known may stand at a place: words only in a sentence that is known, and no
         * two sentences.
         */
        boolean takes(Place place, String value) {
            return JOINTS.stream().noneMatch(value::contains)
                    && (place.quoted() || length >= FEW || !WORD.matcher(value).find());
        }
    }

    /**
     * Makes the sentences of a language.
     *
     * @param english the English patterns by key, as {@link MessageFormat} reads them
     * @param told the same in the other language
     * @param names gives the word for a name that files use for a number, such as {@code walk.radius}
     */
    Sentences(Map<String, String> english, Function<String, String> told, Function<String, Optional<String>> names) {
        this.names = names;
        List<Rule> all = new ArrayList<>();
        english.forEach((key, pattern) -> all.add(rule(pattern.replace("''", "'"), told.apply(key))));
        all.sort(Comparator.comparingInt(Rule::length).reversed().thenComparing(Rule::told));
        rules = List.copyOf(all);
    }

    private static Rule rule(String pattern, String told) {
        StringBuilder regex = new StringBuilder();
        List<Place> places = new ArrayList<>();
        Matcher place = PLACE.matcher(pattern);
        int end = 0;
        int length = 0;
        while (place.find()) {
            boolean quoted = place.start() > 0 && pattern.charAt(place.start() - 1) == '\'';
            regex.append(Pattern.quote(pattern.substring(end, place.start()))).append(quoted ? "(.*?)" : "(.+?)");
            String around = pattern.substring(Math.max(0, place.start() - 1), place.start())
                    + pattern.substring(place.end(), Math.min(pattern.length(), place.end() + 1));
            places.add(new Place(
                    Integer.parseInt(place.group(1)),
                    quoted,
                    VERBATIM.matcher(around).find()));
            length += place.start() - end;
            end = place.end();
        }
        regex.append(Pattern.quote(pattern.substring(end)));
        return new Rule(
                Pattern.compile(regex.toString(), Pattern.DOTALL), places, told, length + pattern.length() - end);
    }

    /** Returns a sentence in the other language, or as it is if it is not known. Cost O(patterns). */
    String tell(String sentence) {
        return told(sentence, new HashMap<>()).orElse(sentence);
    }

    /** Tells a sentence; {@code known} remembers each part, as a part may be asked for again and again. */
    private Optional<String> told(String sentence, Map<String, Optional<String>> known) {
        Optional<String> before = known.get(sentence);
        if (before == null) {
            before = fitted(sentence, known);
            known.put(sentence, before);
        }
        return before;
    }

    private Optional<String> fitted(String sentence, Map<String, Optional<String>> known) {
        for (Rule rule : rules) {
            Matcher matcher = rule.english().matcher(sentence);
            Object[] values = new Object[10];
            boolean fits = matcher.matches();
            for (int i = 0; fits && i < rule.places().size(); i++) {
                Place place = rule.places().get(i);
                String there = matcher.group(i + 1);
                Optional<String> value = place.verbatim() ? Optional.empty() : value(there, known);
                fits = value.isPresent() || rule.takes(place, there);
                values[place.number()] = value.orElse(there);
            }
            if (fits) {
                return Optional.of(new MessageFormat(rule.told(), Locale.ROOT).format(values));
            }
        }
        return joined(sentence, known);
    }

    /** Tells two sentences that are joined, or one behind a name, if the last part is known. */
    private Optional<String> joined(String sentence, Map<String, Optional<String>> known) {
        for (String joint : JOINTS) {
            for (int at = sentence.indexOf(joint); at > 0; at = sentence.indexOf(joint, at + 1)) {
                Optional<String> first = told(sentence.substring(0, at), known);
                Optional<String> last = told(sentence.substring(at + joint.length()), known);
                if (last.isPresent() && (first.isPresent() || joint.equals(": "))) {
                    String begin = first.orElse(sentence.substring(0, at));
                    return Optional.of(begin + (joint.equals(": ") ? "\uff1a" : "\uff1b") + last.get());
                }
            }
        }
        return Optional.empty();
    }

    private Optional<String> value(String text, Map<String, Optional<String>> known) {
        Matcher number = NAMED_NUMBER.matcher(text);
        if (number.matches()) {
            Optional<String> name = names.apply(number.group(1));
            if (name.isPresent()) {
                return Optional.of(name.get() + " " + number.group(2));
            }
        }
        return names.apply(text).or(() -> told(text, known));
    }
}
