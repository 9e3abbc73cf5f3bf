package troupe.scene.xml;

import static troupe.scene.Numbers.text;

import java.util.Locale;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;
import troupe.scene.setting.ActorForm;
import troupe.scene.setting.Orderings;
import troupe.scene.setting.XmlText;

/** Writes a scene as XML: one element a line, attributes in a fixed order, defaults left out. */
final class SceneWriter {
    private final StringBuilder out = new StringBuilder();

    String write(Scene scene) {
        out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        out.append("<scene xmlns=\"").append(SceneXml.NAMESPACE).append('"');
        attribute("title", scene.title(), "");
        out.append(">\n");
        world(scene.world());
        scene.obstacles().forEach(this::obstacle);
        scene.ditches().forEach(this::ditch);
        scene.actors().forEach(this::actor);
        scene.tasks().forEach(this::task);
        return out.append("</scene>\n").toString();
    }

    private void world(World world) {
        out.append("  <world");
        attribute("width", text(world.width()), "");
        attribute("depth", text(world.depth()), "");
        attribute(
                "cell",
                text(world.cell()),
                text(World.of(world.width(), world.depth()).cell()));
        out.append("/>\n");
    }

    private void obstacle(Obstacle obstacle) {
        out.append("  <obstacle");
        named(obstacle);
        attribute("colour", obstacle.colour(), "");
        attribute("offset", text(obstacle.offset()), "0");
        attribute("height", text(obstacle.height()), "");
        attribute("movable", Boolean.toString(obstacle.movable()), "false");
        attribute("mass", text(obstacle.mass()), text(Obstacle.DEFAULT_MASS));
        attribute("points", text(obstacle.outline()), "");
        out.append("/>\n");
    }

    private void ditch(Ditch ditch) {
        out.append("  <ditch");
        named(ditch);
        attribute("depth", text(ditch.depth()), "");
        attribute("points", text(ditch.outline()), "");
        out.append("/>\n");
    }

    private void actor(Actor actor) {
        ActorForm form = ActorForm.of(actor);
        out.append("  <actor");
        named(actor);
        attribute("colour", actor.colour(), "");
        for (String name : ActorForm.BODY) {
            if (!form.isDefault(name)) {
                attribute(name, text(form.body(name)), "");
            }
        }
        out.append(">\n");
        for (Ability ability : form.abilities()) {
            out.append("    <").append(ability.key());
            for (String name : ActorForm.names(ability)) {
                if (!form.isDefault(ability, name)) {
                    attribute(name, text(form.number(ability, name)), "");
                }
            }
            out.append("/>\n");
        }
        out.append("  </actor>\n");
    }

    private void task(Task task) {
        if (task instanceof Journey journey) {
            journey(journey);
        } else if (task instanceof Encounter encounter) {
            encounter(encounter);
        } else if (task instanceof Crowd crowd) {
            out.append("  <crowd");
            named(crowd);
            CrowdXml.write(crowd, this);
        }
    }

    private void encounter(Encounter encounter) {
        out.append("  <encounter");
        named(encounter);
        EncounterForm.attributes(encounter, this::attribute);
        if (encounter.avatars().isEmpty()) {
            out.append("/>\n");
            return;
        }
        out.append(">\n");
        encounter.avatars().forEach(this::avatar);
        out.append("  </encounter>\n");
    }

    private void avatar(Avatar avatar) {
        out.append("    <avatar");
        EncounterForm.attributes(avatar, this::attribute);
        if (avatar.motion() instanceof Avatar.Script script && !script.heads().isEmpty()) {
            out.append(">\n");
            for (Avatar.Head head : script.heads()) {
                out.append("      <head");
                attribute("to", text(head.to()), "");
                attribute("at", head.at().isPresent() ? text(head.at().getAsDouble()) : "", "");
                out.append("/>\n");
            }
            out.append("    </avatar>\n");
        } else if (avatar.motion() instanceof Avatar.Recording recording) {
            out.append(">\n      <track");
            attribute("points", EncounterForm.points(recording), "");
            out.append("/>\n    </avatar>\n");
        } else {
            out.append("/>\n");
        }
    }

    private void journey(Journey journey) {
        out.append("  <journey");
        named(journey);
        attribute("actor", journey.actor(), "");
        attribute("start", text(journey.start()), "");
        attribute("goal", text(journey.goal()), "");
        attribute("ordering", Orderings.text(journey.ordering()), "optimal");
        attribute("spread", journey.spread().name().toLowerCase(Locale.ROOT), "breadth");
        attribute("manipulation", journey.manipulation().name().toLowerCase(Locale.ROOT), "grip");
        attribute("headings", Integer.toString(journey.headings()), Integer.toString(Journey.DEFAULT_HEADINGS));
        attribute("slice", Integer.toString(journey.slice()), Integer.toString(Journey.DEFAULT_SLICE));
        attribute("expansions", Long.toString(journey.expansions()), Long.toString(Journey.DEFAULT_EXPANSIONS));
        attribute("spaces", Integer.toString(journey.spaces()), Integer.toString(Journey.DEFAULT_SPACES));
        attribute("seed", Long.toString(journey.seed()), "1");
        if (journey.preferences().equals(Preferences.NEUTRAL)) {
            out.append("/>\n");
            return;
        }
        out.append(">\n    <prefer");
        for (Ability ability : Ability.values()) {
            attribute(ability.key(), Orderings.factor(journey.preferences().of(ability)), "1");
        }
        out.append("/>\n  </journey>\n");
    }

    private void named(Element element) {
        attribute("id", element.id(), null);
        attribute("label", element.label(), "");
    }

    /** Adds text as it is. */
    void raw(String text) {
        out.append(text);
    }

    /** Adds an attribute unless its value is the one that absence stands for. */
    void attribute(String name, String value, String absent) {
        if (value.equals(absent)) {
            return;
        }
        out.append(' ').append(name).append("=\"");
        XmlText.escape(value, out);
        out.append('"');
    }
}
