package troupe.crowd.flock;

import troupe.scene.Crowd;

/**
 * Holds the factors of the forces in a form for the inner loop: weights, and relation vectors by depth. Replaced as a
 * whole when a value is given while the crowd moves. The arrays are not to be changed.
 */
final class Pull {
    final double separation;
    final double cohesion;
    final double alignment;
    final double path;
    final double anticipation;
    final double[] kinSeparation;
    final double[] kinCohesion;
    final double[] kinAlignment;

    Pull(Crowd crowd) {
        Crowd.Weights w = crowd.weights();
        separation = w.separation();
        cohesion = w.cohesion();
        alignment = w.alignment();
        path = w.path();
        anticipation = w.anticipation();
        int depths = crowd.deepest() + 1;
        kinSeparation = new double[depths];
        kinCohesion = new double[depths];
        kinAlignment = new double[depths];
        for (int d = 0; d < depths; d++) {
            Crowd.Relation relation = crowd.relation(d);
            kinSeparation[d] = relation.separation();
            kinCohesion[d] = relation.cohesion();
            kinAlignment[d] = relation.alignment();
        }
    }
}
