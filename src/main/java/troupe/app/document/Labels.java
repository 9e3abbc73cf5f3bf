package troupe.app.document;

import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;

/** Gives elements other labels and ids. Pure; an element of another kind stays as it is. */
public final class Labels {
    private Labels() {}

    /** Tells whether an element of this kind can be given another label. */
    public static boolean canLabel(Element element) {
        return element instanceof Obstacle
                || element instanceof Ditch
                || element instanceof Actor
                || element instanceof Journey
                || element instanceof Encounter;
    }

    /** Returns an element with another label. */
    public static Element labelled(Element element, String label) {
        return named(element, element.id(), label);
    }

    /** Returns an obstacle or a ditch, an actor, a journey or an encounter with another id and label; another element as it is. */
    public static Element named(Element element, String id, String label) {
        if (element instanceof Obstacle o) {
            return new Obstacle(id, label, o.outline(), o.offset(), o.height(), o.movable(), o.mass(), o.colour());
        }
        if (element instanceof Ditch d) {
            return new Ditch(id, label, d.outline(), d.depth());
        }
        if (element instanceof Actor a) {
            return new Actor(
                    id,
                    label,
                    a.colour(),
                    a.bodyHeight(),
                    a.footRadius(),
                    a.stepHeight(),
                    a.maxBorder(),
                    a.walk(),
                    a.sidestep(),
                    a.stride(),
                    a.vault(),
                    a.move());
        }
        if (element instanceof Encounter e) {
            return new Encounter(
                    id,
                    label,
                    e.actor(),
                    e.start(),
                    e.goal(),
                    e.avatars(),
                    e.method(),
                    e.ordering(),
                    e.influence(),
                    e.growth(),
                    e.numbers(),
                    e.seed());
        }
        return element instanceof Journey j ? named(j, id, label) : element;
    }

    /** Returns a journey of another actor. */
    public static Journey acted(Journey j, String actor) {
        return new Journey(
                j.id(),
                j.label(),
                actor,
                j.start(),
                j.goal(),
                j.preferences(),
                j.ordering(),
                j.spread(),
                j.manipulation(),
                j.headings(),
                j.slice(),
                j.expansions(),
                j.seed());
    }

    private static Journey named(Journey j, String id, String label) {
        return new Journey(
                id,
                label,
                j.actor(),
                j.start(),
                j.goal(),
                j.preferences(),
                j.ordering(),
                j.spread(),
                j.manipulation(),
                j.headings(),
                j.slice(),
                j.expansions(),
                j.seed());
    }
}
