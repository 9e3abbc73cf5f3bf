package troupe;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.module.Configuration;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.lang.module.ResolvedModule;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import troupe.scene.Scene;

/** Asserts the one direction of dependency between packages, and that the program needs the JDK alone. */
class DependencyTest {
    private static final Map<String, Set<String>> MAY_USE = table();
    private static final Set<String> MODULES =
            Set.of("java.base", "java.desktop", "java.datatransfer", "java.xml", "java.prefs", "java.logging");
    private static final Pattern USE = Pattern.compile("^\\s+(\\S+)\\s+->\\s+(\\S+)\\s+(.*\\S)\\s*$");

    private record Use(String from, String to, String where) {
        @Override
        public String toString() {
            return from + " -> " + to;
        }
    }

    private static Map<String, Set<String>> table() {
        Map<String, Set<String>> table = new LinkedHashMap<>();
        table.put("geometry", Set.of());
        table.put("scene", Set.of("geometry"));
        table.put("search", Set.of());
        table.put("grid", Set.of("search", "scene", "geometry"));
        // a run holds its outcome, which is one of search's types
        table.put("run", Set.of("grid", "scene", "geometry", "search"));
        table.put("figure", Set.of("geometry"));
        Set<String> belowPlanners = Set.of("run", "search", "grid", "figure", "scene", "geometry");
        for (String planner : List.of("unified", "risk", "crowd", "puppet", "story")) {
            table.put(planner, belowPlanners);
        }
        table.put("paint", Set.of("run", "figure", "grid", "scene", "geometry"));
        table.put("exchange", Set.of("paint", "run", "figure", "grid", "scene", "geometry"));
        table.put("work", Set.copyOf(table.keySet()));
        Set<String> belowFronts = Set.copyOf(table.keySet());
        table.put("cli", belowFronts);
        table.put("app", belowFronts);
        return table;
    }

    @Test
    void packagesUseOnlyThoseBelowThem() throws URISyntaxException {
        List<Use> uses = uses();
        assertTrue(uses.stream().anyMatch(u -> packageOf(u.to()).equals("geometry")), "jdeps told nothing: " + uses);
        List<String> offending = new ArrayList<>();
        for (Use use : uses) {
            String from = packageOf(use.from());
            String to = packageOf(use.to());
            if (!from.isEmpty() && !MAY_USE.containsKey(from)) {
                offending.add("package troupe." + from + " is not in the table");
            } else if (!from.isEmpty()
                    && !to.isEmpty()
                    && !from.equals(to)
                    && !MAY_USE.get(from).contains(to)) {
                offending.add(use.toString());
            }
        }
        assertEquals(List.of(), offending);
    }

    @Test
    void packagesFormNoCycle() throws URISyntaxException {
        Map<String, Set<String>> below = new TreeMap<>();
        for (Use use : uses()) {
            String from = folderOf(use.from());
            String to = folderOf(use.to());
            if (use.to().startsWith("troupe.") && !from.equals(to)) {
                below.computeIfAbsent(from, f -> new TreeSet<>()).add(to);
            }
        }
        boolean taken = true;
        while (taken) {
            Set<String> left = Set.copyOf(below.keySet());
            taken = below.values().removeIf(uses -> uses.stream().noneMatch(left::contains));
        }
        assertEquals(Map.of(), below, "each of these uses another of these");
    }

    private static String folderOf(String type) {
        return type.substring(0, type.lastIndexOf('.'));
    }

    @Test
    void windowsAreOnlyInAppAndDrawingOnlyInPaintExchangeAndApp() throws URISyntaxException {
        List<Use> offending = uses().stream()
                .filter(use -> use.to().startsWith("javax.swing.")
                                && !packageOf(use.from()).equals("app")
                        || (use.to().startsWith("java.awt.") || use.to().startsWith("javax.imageio."))
                                && !Set.of("paint", "exchange", "app").contains(packageOf(use.from())))
                .toList();
        assertEquals(List.of(), offending);
    }

    @Test
    void everyClassUsedIsTheProgramsOwnOrOfAFewModules() throws URISyntaxException {
        List<Use> offending = uses().stream()
                .filter(use ->
                        !MODULES.contains(use.where()) && packageOf(use.to()).isEmpty())
                .toList();
        assertEquals(List.of(), offending);
    }

    @Test
    void moduleGraphHoldsModulesOfTheJdkOnly() throws URISyntaxException {
        Configuration graph = ModuleLayer.boot()
                .configuration()
                .resolve(ModuleFinder.of(classes()), ModuleFinder.ofSystem(), Set.of("troupe"));
        ModuleDescriptor program =
                graph.findModule("troupe").orElseThrow().reference().descriptor();
        Set<String> required = program.requires().stream()
                .map(ModuleDescriptor.Requires::name)
                .collect(Collectors.toCollection(TreeSet::new));
        required.removeAll(MODULES);
        assertEquals(Set.of(), required, "modules required beside " + MODULES);
        Set<String> foreign = graph.modules().stream()
                .map(ResolvedModule::name)
                .filter(name -> !name.equals("troupe"))
                .filter(name -> ModuleFinder.ofSystem().find(name).isEmpty())
                .collect(Collectors.toCollection(TreeSet::new));
        assertEquals(Set.of(), foreign, "modules that are not of the JDK");
    }

    private static String packageOf(String type) {
        String[] words = type.split("\\.");
        return words.length > 2 && words[0].equals("troupe") ? words[1] : "";
    }

    private static List<Use> uses() throws URISyntaxException {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = ToolProvider.findFirst("jdeps")
                .orElseThrow()
                .run(
                        new PrintWriter(out),
                        new PrintWriter(err),
                        "-verbose:class",
                        "-filter:none",
                        classes().toString());
        assertEquals(0, code, err.toString());
        List<Use> uses = new ArrayList<>();
        for (String line : out.toString().split("\\R")) {
            Matcher use = USE.matcher(line);
            if (use.matches()) {
                uses.add(new Use(use.group(1), use.group(2), use.group(3)));
            }
        }
        return uses;
    }

    private static Path classes() throws URISyntaxException {
        return Path.of(
                Scene.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    }
}
