/** Troupe: plans how digital actors move. */
module troupe {
    requires transitive java.desktop;
    requires java.xml;
    requires java.prefs;
    requires java.logging;

    exports troupe.geometry;
    exports troupe.scene;
    exports troupe.scene.check;
    exports troupe.scene.setting;
    exports troupe.scene.xml;
    exports troupe.search;
    exports troupe.grid;
    exports troupe.grid.field;
    exports troupe.grid.layer;
    exports troupe.grid.region;
    exports troupe.grid.region.crossing;
    exports troupe.grid.region.ground;
    exports troupe.run;
    exports troupe.run.file;
    exports troupe.run.frame;
    exports troupe.run.view;
    exports troupe.risk;
    exports troupe.risk.forecast;
    exports troupe.risk.plan;
    exports troupe.risk.study;
    exports troupe.unified;
    exports troupe.unified.cost;
    exports troupe.unified.manipulation;
    exports troupe.unified.obstacle;
    exports troupe.unified.search;
    exports troupe.crowd;
    exports troupe.crowd.flock;
    exports troupe.crowd.ground;
    exports troupe.paint;
    exports troupe.paint.field;
    exports troupe.paint.motion;
    exports troupe.paint.picture;
    exports troupe.paint.scene;
    exports troupe.paint.solid;
    exports troupe.exchange;
    exports troupe.exchange.format;
    exports troupe.exchange.picture;
    exports troupe.exchange.scenario;
    exports troupe.exchange.script;
    exports troupe.exchange.track;
    exports troupe.work;
    exports troupe.work.batch;
    exports troupe.work.explain;
    exports troupe.work.inspect;
    exports troupe.work.view;

    uses troupe.work.Window;

    provides troupe.work.Window with
            troupe.app.StudioFront;
}
