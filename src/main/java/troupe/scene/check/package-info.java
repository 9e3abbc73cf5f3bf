/**
 * Holds what is checked of a scene without a grid: a table of rules, each of which names the element, what is wrong
 * with it and the cure. Checks never throw and never change anything. May use {@code scene} and {@code geometry}.
 */
package troupe.scene.check;
