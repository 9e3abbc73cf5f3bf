package troupe.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Holds what a planner tells about a run: an ordered tree of named values. A value is a {@link String},
 * a {@link Boolean}, a {@link Long}, a finite {@link Double}, a {@link List} of values or a nested
 * {@link Report}. Immutable. Names that end in {@code _ms} hold wall time and take no part in a digest.
 */
public final class Report {
    private final Map<String, Object> values;

    private Report(Map<String, Object> values) {
        this.values = values;
    }

    /** Returns the values in the order in which they were put. */
    public Map<String, Object> values() {
        return values;
    }

    /** Starts a report. */
    public static Builder builder() {
        return new Builder();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Report r && values.equals(r.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    @Override
    public String toString() {
        return values.toString();
    }

    /** Collects the values of a report. */
    public static final class Builder {
        private final Map<String, Object> values = new LinkedHashMap<>();

        private Builder() {}

        /**
         * Adds a value under a new name.
         *
         * @throws IllegalArgumentException if the name is taken or the value is of another kind
         */
        public Builder put(String name, Object value) {
            if (values.putIfAbsent(name, checked(name, value)) != null) {
                throw new IllegalArgumentException("report value '" + name + "' is there already");
            }
            return this;
        }

        private static Object checked(String name, Object value) {
            if (value instanceof Integer i) {
                return i.longValue();
            }
            if (value instanceof List<?> list) {
                return list.stream().map(v -> checked(name, v)).toList();
            }
            boolean known = value instanceof String
                    || value instanceof Boolean
                    || value instanceof Long
                    || value instanceof Report
                    || value instanceof Double d && Double.isFinite(d);
            if (!known) {
                throw new IllegalArgumentException("report value '" + name + "' = " + value
                        + "; needs text, a truth value, a whole or finite number, a list or a report");
            }
            return value;
        }

        /** Returns the report. */
        public Report build() {
            return new Report(Collections.unmodifiableMap(new LinkedHashMap<>(values)));
        }
    }
}
