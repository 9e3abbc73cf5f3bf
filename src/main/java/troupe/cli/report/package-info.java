/**
 * Writes what commands tell, as tables and pictures.
 */
package troupe.cli.report;
