package troupe.app.property;

import java.util.List;

/** Holds properties that belong together; {@code key} is the word for their heading, empty for none. */
public record Group(String key, List<Property> properties) {}
