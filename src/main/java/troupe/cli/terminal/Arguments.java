package troupe.cli.terminal;

import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** Holds what was typed after the name of a command: the values of its options, and the words beside them. */
public final class Arguments {
    private final Map<String, List<String>> options = new TreeMap<>();
    private final List<String> words = new ArrayList<>();

    private Arguments() {}

    /**
     * Sorts what was typed by the options of a command: {@code --name value}, {@code --name=value}, and
     * after {@code --} words only. A lone {@code -} is a word.
     *
     * @throws UsageException if an option is unknown, lacks its value, or is given too often
     */
    public static Arguments parse(Command command, List<String> typed) throws UsageException {
        Arguments arguments = new Arguments();
        for (int i = 0; i < typed.size(); i++) {
            String word = typed.get(i);
            if (word.equals("--")) {
                arguments.words.addAll(typed.subList(i + 1, typed.size()));
                break;
            }
            if (!word.startsWith("-") || word.equals("-")) {
                arguments.words.add(word);
                continue;
            }
            int equals = word.startsWith("--") ? word.indexOf('=') : -1;
            Option option = find(command, equals < 0 ? word : word.substring(0, equals));
            if (!option.takesValue()) {
                if (equals >= 0) {
                    throw new UsageException(option.name() + " takes no value");
                }
                arguments.add(option, "");
            } else if (equals >= 0) {
                arguments.add(option, word.substring(equals + 1));
            } else if (i + 1 < typed.size()) {
                arguments.add(option, typed.get(++i));
            } else {
                throw new UsageException(option.name() + " needs a value: " + option.value());
            }
        }
        return arguments;
    }

    private static Option find(Command command, String name) throws UsageException {
        for (Option option : command.options()) {
            if (option.name().equals(name)) {
                return option;
            }
        }
        String known = command.options().stream().map(Option::name).collect(Collectors.joining(", "));
        throw new UsageException("unknown option " + name + "; " + command.name() + " knows "
                + (known.isEmpty() ? "none" : known) + (known.isEmpty() ? "" : ", --help"));
    }

    private void add(Option option, String value) throws UsageException {
        List<String> values = options.computeIfAbsent(option.name(), k -> new ArrayList<>());
        if (!values.isEmpty() && !option.repeated()) {
            throw new UsageException(option.name() + " is given twice");
        }
        values.add(value);
    }

    /** Returns the number of words beside the options. */
    public int count() {
        return words.size();
    }

    /**
     * Returns the only word beside the options.
     *
     * @throws UsageException if there is none or more than one
     */
    public String only(String what) throws UsageException {
        if (words.size() != 1) {
            throw new UsageException(
                    words.isEmpty() ? "needs " + what : "one " + what + " only, not " + String.join(" ", words));
        }
        return words.get(0);
    }

    /** Tells whether an option was given. */
    public boolean has(String option) {
        return options.containsKey(option);
    }

    /** Returns the value of an option, empty if it was not given. */
    public Optional<String> value(String option) {
        return all(option).stream().findFirst();
    }

    /** Returns all values of an option in the order in which they were given. */
    public List<String> all(String option) {
        return options.getOrDefault(option, List.of());
    }

    /** Returns a value that must be there. */
    public String needed(String option, String what) throws UsageException {
        return value(option).orElseThrow(() -> new UsageException("needs " + option + " " + what));
    }

    /** Returns a whole number within a range, or nothing if the option is not there. */
    public Optional<Long> whole(String option, long least, long most) throws UsageException {
        Optional<String> text = value(option);
        if (text.isEmpty()) {
            return Optional.empty();
        }
        try {
            long number = Long.parseLong(text.get());
            if (number >= least && number <= most) {
                return Optional.of(number);
            }
        } catch (NumberFormatException e) {
            // told below, like a number out of range
        }
        throw new UsageException(option + " " + text.get() + "; needs a whole number from " + least + " to " + most);
    }

    /** Returns a finite number, or nothing if the option is not there. */
    public Optional<Double> number(String option) throws UsageException {
        Optional<String> text = value(option);
        if (text.isEmpty()) {
            return Optional.empty();
        }
        try {
            double number = Double.parseDouble(text.get());
            if (Double.isFinite(number)) {
                return Optional.of(number);
            }
        } catch (NumberFormatException e) {
            // told below, like what is not finite
        }
        throw new UsageException(option + " " + text.get() + "; needs a number");
    }

    /** Makes a path of a word. */
    public static Path path(String word) throws UsageException {
        try {
            return Path.of(word);
        } catch (InvalidPathException e) {
            throw new UsageException("'" + word + "' is no name of a file", e);
        }
    }

    /**
     * Makes the path of a file that is to be read.
     *
     * @throws FileSystemException if it is a folder
     */
    public static Path input(String word) throws UsageException, FileSystemException {
        Path file = path(word);
        if (Files.isDirectory(file)) {
            throw new FileSystemException(word, null, "is a folder; needs a file");
        }
        return file;
    }
}
