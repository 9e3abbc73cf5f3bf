package troupe.app.plan;

import troupe.app.document.Version;
import troupe.scene.Scene;

/** Holds what a plan is made from: the scene of one version of the document, and the id of the task. */
public record Snapshot(Version version, Scene scene, String task) {}
