package troupe.exchange;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Checks MEL as far as our scripts use it: tokens, balance of brackets and backquotes, an end to every statement,
 * variables declared before they are used, procedures called with as many arguments as they take, and commands with
 * flags that they know.
 */
public final class MelGrammar {
    private static final Pattern TOKEN = Pattern.compile("\\s+|//[^\\n]*|\"(?:[^\"\\\\\\n]|\\\\.)*\"|-[a-zA-Z]\\w*"
            + "|-?\\d+(?:\\.\\d+)?|\\$\\w+|[A-Za-z]\\w*|==|[-+*/=;,(){}\\[\\]`]");
    private static final Map<String, Set<String>> COMMANDS = new TreeMap<>(Map.ofEntries(
            command("shadingNode", "-asShader -name"),
            command("setAttr", "-type"),
            command("sets", "-renderable -noSurfaceShader -empty -name -edit -forceElement"),
            command("connectAttr", "-force"),
            command("polyExtrudeFacet", "-constructionHistory -localTranslateZ"),
            command("polyCloseBorder", "-constructionHistory"),
            command("polyCreateFacet", "-constructionHistory -name -point"),
            command("parent", "-relative"),
            command("setKeyframe", "-time -value -attribute -inTangentType -outTangentType"),
            command("currentUnit", "-query -linear -angle"),
            command("group", "-empty -world -name"),
            command("playbackOptions", "-minTime -maxTime -animationStartTime -animationEndTime"),
            command("upAxis", "-query -axis")));
    private static final Set<String> WORDS = Set.of(
            "global", "proc", "string", "float", "int", "return", "if", "lambert", "true", "on", "off", "double3");

    private final List<String> tokens = new ArrayList<>();
    private final Map<String, Integer> procedures = new TreeMap<>();

    private static Map.Entry<String, Set<String>> command(String name, String flags) {
        return Map.entry(name, new TreeSet<>(Arrays.asList(flags.split(" "))));
    }

    private MelGrammar() {}

    /** Returns how often each procedure is called; fails at the first mistake. */
    public static Map<String, Integer> check(String text) {
        return new MelGrammar().calls(text);
    }

    private static void require(boolean right, String wrong) {
        if (!right) {
            throw new AssertionError(wrong);
        }
    }

    private Map<String, Integer> calls(String text) {
        Matcher matcher = TOKEN.matcher(text);
        int at = 0;
        while (at < text.length()) {
            matcher.region(at, text.length());
            require(matcher.lookingAt(), "no token at '" + text.substring(at, Math.min(text.length(), at + 40)) + "'");
            String token = matcher.group();
            if (!token.isBlank() && !token.startsWith("//")) {
                tokens.add(token);
            }
            at = matcher.end();
        }
        balance();
        declare();
        variables();
        return statements();
    }

    private void balance() {
        List<String> open = new ArrayList<>();
        boolean quoted = false;
        int assignments = 0;
        for (String token : tokens) {
            assignments = ";{}".contains(token) ? 0 : assignments + (token.equals("=") ? 1 : 0);
            require(assignments < 2, "two assignments in a statement");
            if ("({[".contains(token)) {
                open.add(token);
            } else if (")}]".contains(token)) {
                require(!open.isEmpty(), "closes nothing: " + token);
                String last = open.remove(open.size() - 1);
                require("({[".indexOf(last) == ")}]".indexOf(token), last + " closed by " + token);
            } else if (token.equals("`")) {
                quoted = !quoted;
            } else if (token.equals(";")) {
                require(!quoted && !open.contains("(") && !open.contains("["), "a statement ends within brackets");
            }
        }
        require(open.isEmpty() && !quoted, "left open: " + open);
        require(List.of(";", "}").contains(tokens.get(tokens.size() - 1)), "the last statement has no end");
    }

    private void declare() {
        for (int i = 0; i < tokens.size(); i++) {
            if (tokens.get(i).equals("proc")) {
                int name = tokens.get(i + 2).equals("(") ? i + 1 : i + 2;
                int count = 0;
                for (int k = name + 2; !tokens.get(k).equals(")"); k++) {
                    count += tokens.get(k).startsWith("$") ? 1 : 0;
                }
                procedures.put(tokens.get(name), count);
            }
        }
    }

    private void variables() {
        Set<String> known = new TreeSet<>();
        for (int i = 0; i < tokens.size(); i++) {
            if (tokens.get(i).startsWith("$")) {
                if (Set.of("string", "float", "int").contains(tokens.get(i - 1))) {
                    known.add(tokens.get(i));
                }
                require(known.contains(tokens.get(i)), "not declared: " + tokens.get(i));
            }
        }
    }

    private Map<String, Integer> statements() {
        Map<String, Integer> calls = new TreeMap<>();
        String command = "";
        for (int i = 0; i < tokens.size(); i++) {
            String token = tokens.get(i);
            boolean called = procedures.containsKey(token) && tokens.get(i + 1).equals("(");
            if (called && !isDeclaration(i)) {
                require(arguments(i + 2) == procedures.get(token), token + " with " + arguments(i + 2) + " arguments");
                calls.merge(token, 1, Integer::sum);
            } else if (COMMANDS.containsKey(token)) {
                command = token;
            } else if (Character.isLetter(token.charAt(0))) {
                require(WORDS.contains(token) || procedures.containsKey(token), "unknown word " + token);
            } else if (token.matches("-[a-zA-Z]\\w*")) {
                require(COMMANDS.getOrDefault(command, Set.of()).contains(token), command + " does not know " + token);
            }
        }
        return calls;
    }

    private boolean isDeclaration(int i) {
        return tokens.get(i - 1).equals("proc") || tokens.get(i - 2).equals("proc");
    }

    private int arguments(int from) {
        int count = 1;
        for (int k = from; !tokens.get(k).equals(")"); k++) {
            count += tokens.get(k).equals(",") ? 1 : 0;
        }
        return count;
    }
}
