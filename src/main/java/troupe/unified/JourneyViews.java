package troupe.unified;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.run.view.Aspect;
import troupe.run.view.GridOverlays;
import troupe.run.view.Overlay;
import troupe.unified.manipulation.ConfigurationSpace;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.obstacle.Movable;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.MoveAttempt;
import troupe.unified.search.SearchSpace;

/**
 * Shows what a journey's search works on, for one search space at a time: its region, where the search has
 * been, the trigger points, and of one manipulation instance the expected path and, heading by heading, the
 * poses that bar it.
 */
final class JourneyViews {
    /** The keys of the potential's views, which belong to the region without what may be moved. */
    private static final List<String> GUIDES = List.of("skeleton", "potential");

    /** The keys of the views that differ between search spaces, between instances, and between headings. */
    private static final List<String> BY_SPACE = List.of(
            "region", "class", "clearance", "crossings", "opening", "effort", "triggers", "expected-path", "instance");

    private static final List<String> BY_INSTANCE = List.of("expected-path", "instance");
    private static final List<String> BY_HEADING = List.of("instance");

    private final Preparation prepared;
    private final Optional<JourneySearch> search;

    JourneyViews(Preparation prepared, Optional<JourneySearch> search) {
        this.prepared = prepared;
        this.search = search;
    }

    /** Returns the choices: a search space, an instance in it, a heading of its obstacle; none where nothing may be moved. */
    List<Aspect> aspects(List<Integer> chosen) {
        if (search.isEmpty() || prepared.movables().isEmpty()) {
            return List.of();
        }
        List<Aspect> aspects = new ArrayList<>();
        aspects.add(new Aspect(
                "space",
                search.get().spaces().stream().map(JourneyViews::choice).toList(),
                BY_SPACE));
        SearchSpace space = space(chosen);
        if (!space.attempts().isEmpty()) {
            List<Aspect.Choice> instances = new ArrayList<>();
            for (MoveAttempt attempt : space.attempts()) {
                instances.add(Aspect.Choice.of(
                        "instance",
                        (instances.size() + 1) + ": "
                                + attempt.obstacle().obstacle().name()));
            }
            Aspect instance = new Aspect("instance", instances, BY_INSTANCE);
            aspects.add(instance);
            Movable movable = space.attempts().get(instance.chosen(chosen, 1)).obstacle();
            List<Aspect.Choice> headings = new ArrayList<>();
            for (int k = 0; k < movable.headings(); k++) {
                headings.add(Aspect.Choice.of("degrees", degrees(360.0 * k / movable.headings())));
            }
            aspects.add(new Aspect("heading", headings, BY_HEADING));
        }
        return aspects;
    }

    private static String degrees(double degrees) {
        return degrees == Math.rint(degrees)
                ? Integer.toString((int) degrees)
                : String.format(Locale.ROOT, "%.1f", degrees);
    }

    private static Aspect.Choice choice(SearchSpace space) {
        List<Movable> moved = space.moved();
        return moved.isEmpty()
                ? Aspect.Choice.of("scene")
                : new Aspect.Choice(
                        "moved", moved.stream().map(m -> m.obstacle().name()).collect(Collectors.toList()));
    }

    private SearchSpace space(List<Integer> chosen) {
        List<SearchSpace> spaces = search.orElseThrow().spaces();
        int number = chosen.isEmpty() ? 0 : chosen.get(0);
        return spaces.get(number >= 0 && number < spaces.size() ? number : 0);
    }

    /**
     * Returns those views of a choice of {@link #aspects} that are wanted.
     *
     * @throws java.util.concurrent.CancellationException if the thread is interrupted
     */
    List<Overlay> overlays(List<Integer> chosen, Predicate<String> wanted) {
        List<Overlay> views = new ArrayList<>();
        List<String> guides = GUIDES.stream().filter(wanted).toList();
        List<String> others = GridOverlays.KEYS.stream()
                .filter(key -> !GUIDES.contains(key) && wanted.test(key))
                .toList();
        Region region = search.isPresent() ? space(chosen).region() : prepared.region();
        boolean local = !others.isEmpty() || BY_SPACE.stream().anyMatch(wanted);
        GridOverlays grid = local ? new GridOverlays(region, prepared.layers()) : null;
        others.forEach(key -> views.addAll(grid.of(key, null)));
        if (!guides.isEmpty() && prepared.goal().configuration() >= 0) {
            boolean same = region == prepared.open() && local;
            GridOverlays guide = same ? grid : new GridOverlays(prepared.open(), prepared.layers());
            guides.forEach(key -> views.addAll(guide.of(key, prepared.potential())));
        }
        if (search.isPresent() && local) {
            addSearched(chosen, grid, wanted, views);
        }
        return List.copyOf(views);
    }

    private void addSearched(List<Integer> chosen, GridOverlays grid, Predicate<String> wanted, List<Overlay> views) {
        SearchSpace space = space(chosen);
        if (wanted.test("effort")) {
            views.addAll(SearchEffort.of(prepared.layers(), search.orElseThrow(), space));
        }
        if (wanted.test("triggers")) {
            views.addAll(triggers(space, grid));
        }
        if (!space.attempts().isEmpty() && BY_INSTANCE.stream().anyMatch(wanted)) {
            List<Aspect> aspects = aspects(chosen);
            MoveAttempt attempt = space.attempts().get(aspects.get(1).chosen(chosen, 1));
            int storey = grid.storey(prepared.layers().layer(attempt.trigger()));
            views.add(path(attempt.path(), storey));
            views.add(barred(
                    attempt.barred(),
                    aspects.get(2).chosen(chosen, 2),
                    space.region().frame(),
                    storey));
        }
    }

    private List<Overlay> triggers(SearchSpace space, GridOverlays grid) {
        List<List<Double>> storeys = new ArrayList<>();
        for (int m = 0; m < prepared.movables().size(); m++) {
            for (int q : space.triggerPoints(m)) {
                int storey = grid.storey(prepared.layers().layer(q));
                while (storeys.size() <= storey) {
                    storeys.add(new ArrayList<>());
                }
                storeys.get(storey).add(space.region().x(q));
                storeys.get(storey).add(space.region().y(q));
            }
        }
        List<Overlay> views = new ArrayList<>();
        for (int k = 0; k < storeys.size(); k++) {
            if (!storeys.get(k).isEmpty()) {
                double[] points =
                        storeys.get(k).stream().mapToDouble(Double::doubleValue).toArray();
                views.add(new Overlay.Points("triggers", k, points));
            }
        }
        return views;
    }

    private static Overlay path(ExpectedPath path, int storey) {
        double[] line = new double[2 * path.size()];
        for (int n = 0; n < path.size(); n++) {
            line[2 * n] = path.frame().centreX(path.frame().col(path.cell(n)));
            line[2 * n + 1] = path.frame().centreY(path.frame().row(path.cell(n)));
        }
        return new Overlay.Lines("expected-path", storey, List.of(line));
    }

    private static Overlay barred(ConfigurationSpace barred, int heading, GridFrame frame, int storey) {
        float[] values = new float[frame.size()];
        Arrays.fill(values, Float.NaN);
        for (int cell : barred.poses(heading)) {
            values[cell] = 0;
        }
        return new Overlay.Field("instance", storey, frame, values, new Overlay.Categories(List.of("bars-path")));
    }
}
