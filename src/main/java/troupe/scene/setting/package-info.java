/**
 * Holds the dotted settings that mirror the scene file, {@code actor.vault.reach=1.2}, and the words and numbers
 * that they and the file share. May use {@code scene} and {@code geometry}.
 */
package troupe.scene.setting;
