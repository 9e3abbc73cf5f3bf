/**
 * Lists what can be changed of the things in a scene, as texts with units that are checked as they are typed.
 *
 * <p>Guarantees: pure; a text that cannot be taken is an {@link IllegalArgumentException} that says why. Tasks
 * of any kind and actors show the settings that {@link troupe.scene.setting.Settings} knows of them. May use
 * {@code app.document}, {@code app.look}'s texts, {@code scene} and {@code geometry}.
 */
package troupe.app.property;
