package troupe.app.compare;

import java.util.StringJoiner;
import java.util.regex.Pattern;
import troupe.app.look.Texts;

/** Gives the words for the names and values of reports, which are those of run files. Immutable. */
final class ReportWords {
    private static final Pattern NUMBER = Pattern.compile("\\d+");

    private static final Pattern LONG = Pattern.compile("-?\\d+\\.\\d{4,}");

    private final Texts texts;

    /** Makes the words of a language. */
    ReportWords(Texts texts) {
        this.texts = texts;
    }

    /** Returns what to call a value: each part of its name by its word, numbers as they are. */
    String name(String dotted) {
        StringJoiner told = new StringJoiner(" \u2013 ");
        String before = "";
        for (String part : dotted.split("\\.")) {
            if (NUMBER.matcher(part).matches() && !before.isEmpty()) {
                before = before + " " + part;
            } else {
                if (!before.isEmpty()) {
                    told.add(before);
                }
                before = word(part);
            }
        }
        return told.add(before).toString();
    }

    /** Returns a value for a person: yes and no, abilities by their words, lists without brackets. */
    String value(String printed) {
        if (printed.startsWith("[") && printed.endsWith("]")) {
            StringJoiner told = new StringJoiner(", ");
            for (String part : printed.substring(1, printed.length() - 1).split(", ")) {
                told.add(LONG.matcher(part).matches() ? brief(part) : texts.get("word." + part, part));
            }
            return told.toString();
        }
        boolean truth = printed.equals("true") || printed.equals("false");
        return truth ? texts.get("report." + printed) : texts.get("value.motion." + printed, split(printed));
    }

    private static String brief(String number) {
        return String.valueOf(Math.rint(Double.parseDouble(number) * 1_000) / 1_000);
    }

    private String split(String printed) {
        return texts.get("value.split." + printed, printed);
    }

    private String word(String part) {
        String stage = texts.get("stage." + part, texts.get("word." + part, part.replace('_', ' ')));
        return texts.get("report." + part, stage);
    }
}
