package troupe.app.problem;

import troupe.scene.Scene;

/**
 * Offers one change that mends a problem.
 *
 * @param key the word for it in texts
 * @param what what it speaks of, may be empty
 * @param mended the scene after it
 */
public record Fix(String key, String what, Scene mended) {}
