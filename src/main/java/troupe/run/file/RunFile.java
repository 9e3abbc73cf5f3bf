package troupe.run.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.zip.Deflater;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import troupe.run.Digest;
import troupe.run.Run;
import troupe.run.frame.BlockFrames;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;
import troupe.scene.setting.Settings;
import troupe.scene.xml.AtomicFile;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.scene.xml.SceneXml;

/**
 * Writes and reads run files: ZIP archives of {@code run.xml}, {@code scene.xml} and the frames in parts of a
 * second ({@code docs/run-format.md}). Equal runs give equal files on one machine. Reading needs no planner,
 * executes nothing, writes nothing, and never takes more memory than the limits below allow.
 */
public final class RunFile {
    /** The most bytes of {@code run.xml}. */
    static final int MAX_MANIFEST = 1 << 25;
    /** The most bytes of {@code scene.xml}. */
    static final int MAX_SCENE = 1 << 26;
    /** Frames of at most so many bytes are held in memory, larger ones stay in the file. */
    static final long HELD_BYTES = 1L << 26;

    private static final LocalDateTime NO_TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

    private RunFile() {}

    /**
     * Writes a run, whole or not at all.
     *
     * @throws IOException if the file cannot be written; what was there before is then still there
     * @throws IllegalArgumentException if the run lacks its task or is larger than a run file can be
     */
    public static void write(Run run, Path file) throws IOException {
        AtomicFile.write(file, out -> write(run, out));
    }

    /** Writes a run to a stream, which stays open. */
    public static void write(Run run, OutputStream out) throws IOException {
        Task task = run.scene()
                .task(run.task())
                .orElseThrow(() -> new IllegalArgumentException("the run's scene lacks its task " + run.task()));
        Frames frames = run.frames();
        FrameLayout layout = new FrameLayout(frames.channels());
        int block = FrameRecorder.checkedBlock(frames.rate(), layout);
        int parts = (frames.count() + block - 1) / block;
        if (parts > RunArchive.MAX_PARTS - 2) {
            throw new IllegalArgumentException(parts + " s of frames; a run file holds " + (RunArchive.MAX_PARTS - 2));
        }
        ZipOutputStream zip = new ZipOutputStream(out, StandardCharsets.UTF_8);
        // frames hardly shrink further at a higher level, and a long run is written many times faster
        zip.setLevel(Deflater.BEST_SPEED);
        byte[] scene = SceneXml.write(run.scene()).getBytes(StandardCharsets.UTF_8);
        put(zip, "scene.xml", scene);
        MessageDigest digest = Digest.begin(frames.channels(), frames.rate(), frames.count());
        List<String> hashes = new ArrayList<>();
        for (int k = 0; k < parts; k++) {
            byte[] part = part(frames, layout, k * block, Math.min(block, frames.count() - k * block));
            digest.update(part);
            hashes.add(Digest.of(part));
            put(zip, RunManifest.partName(k), part);
        }
        RunManifest manifest = new RunManifest(
                program(),
                task.id(),
                task.seed(),
                Settings.values(run.scene(), task.id()),
                run.outcome(),
                run.report(),
                Digest.of(scene),
                frames.rate(),
                frames.count(),
                HexFormat.of().formatHex(digest.digest()),
                frames.channels(),
                hashes,
                run.legs(),
                run.inputs());
        put(zip, "run.xml", RunXmlWriter.write(manifest).getBytes(StandardCharsets.UTF_8));
        zip.finish();
    }

    private static byte[] part(Frames frames, FrameLayout layout, int first, int count) {
        byte[] bytes = new byte[count * layout.bytes()];
        for (int i = 0; i < count; i++) {
            layout.copy(frames, first + i, bytes, i * layout.bytes());
        }
        return bytes;
    }

    private static void put(ZipOutputStream zip, String name, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTimeLocal(NO_TIME);
        zip.putNextEntry(entry);
        zip.write(bytes);
        zip.closeEntry();
    }

    /** Returns the version of this program as run files name it. */
    public static String program() {
        String version = RunFile.class.getPackage().getImplementationVersion();
        return version == null ? "unreleased" : version;
    }

    /**
     * Reads a run and checks every part of it; of a journal ({@link RunJournal}) all frames that are whole.
     *
     * @throws RunException if the file is damaged or no run file; the message begins with the file's name
     * @throws IOException if the file is not there or cannot be opened
     */
    public static Run read(Path file) throws RunException, IOException {
        try {
            if (JournalReader.isJournal(file)) {
                return JournalReader.read(file);
            }
            try (RunArchive archive = new RunArchive(file)) {
                return read(archive, file);
            }
        } catch (RunException e) {
            throw new RunException(file.getFileName() + ": " + e.getMessage(), e);
        }
    }

    private static Run read(RunArchive archive, Path file) throws RunException, IOException {
        RunManifest manifest = RunXmlReader.read(archive.read("run.xml", MAX_MANIFEST));
        byte[] xml = archive.read("scene.xml", MAX_SCENE, manifest.sceneHash());
        Frames frames = frames(archive, file, manifest);
        Scene scene = scene(xml, manifest);
        return new Run(
                scene,
                manifest.task(),
                manifest.outcome(),
                manifest.report(),
                frames,
                manifest.legs(),
                manifest.inputs());
    }

    /** Reads the scene and checks that it is the one of the manifest. */
    static Scene scene(byte[] xml, RunManifest manifest) throws RunException, IOException {
        Scene scene = scene(xml);
        if (scene.task(manifest.task()).isEmpty()) {
            throw new RunException("scene.xml lacks the task '" + RunXmlReader.oneLine(manifest.task()) + "'");
        }
        if (!Settings.values(scene, manifest.task())
                .entrySet()
                .containsAll(manifest.settings().entrySet())) {
            throw new RunException("the settings in run.xml are not those of scene.xml");
        }
        return scene;
    }

    /** Lays the channels of a manifest out and checks their size. */
    static FrameLayout layout(RunManifest manifest) throws RunException {
        try {
            FrameLayout layout = new FrameLayout(manifest.channels());
            FrameRecorder.checkedBlock(manifest.rate(), layout);
            return layout;
        } catch (IllegalArgumentException e) {
            throw new RunException("run.xml: " + e.getMessage(), e);
        }
    }

    /** Reads the scene and refuses one that could not be planned, so that whoever plans it again need not check it. */
    private static Scene scene(byte[] xml) throws RunException, IOException {
        try {
            SceneSource source = SceneXml.read(new ByteArrayInputStream(xml), "scene.xml");
            List<Problem> errors = SceneChecks.check(source.scene(), source.lines()).stream()
                    .filter(p -> p.severity() == Severity.ERROR)
                    .toList();
            if (!errors.isEmpty()) {
                throw new SceneException("scene.xml", errors);
            }
            return source.scene();
        } catch (SceneException e) {
            throw new RunException(e.getMessage(), e);
        }
    }

    private static Frames frames(RunArchive archive, Path file, RunManifest manifest) throws RunException {
        FrameLayout layout = layout(manifest);
        int block = FrameRecorder.framesPerBlock(manifest.rate());
        int parts = (int) (((long) manifest.count() + block - 1) / block);
        if (manifest.partHashes().size() != parts || archive.size() != parts + 2) {
            throw new RunException(manifest.count() + " frames need " + parts + " parts; run.xml lists "
                    + manifest.partHashes().size() + ", and " + (archive.size() - 2) + " are there");
        }
        boolean held = (long) manifest.count() * layout.bytes() <= HELD_BYTES;
        byte[][] blocks = new byte[held ? parts : 0][];
        MessageDigest digest = Digest.begin(manifest.channels(), manifest.rate(), manifest.count());
        for (int k = 0; k < parts; k++) {
            int bytes = Math.min(block, manifest.count() - k * block) * layout.bytes();
            byte[] part = archive.read(
                    RunManifest.partName(k), bytes, manifest.partHashes().get(k));
            if (part.length != bytes) {
                throw new RunException(
                        "part '" + RunManifest.partName(k) + "' has " + part.length + " bytes; needs " + bytes);
            }
            digest.update(part);
            if (held) {
                blocks[k] = part;
            }
        }
        if (!HexFormat.of().formatHex(digest.digest()).equals(manifest.digest())) {
            throw new RunException("the frames do not have the digest that run.xml names");
        }
        return held
                ? new BlockFrames(manifest.rate(), layout, manifest.count(), blocks)
                : new FileFrames(file.toAbsolutePath(), layout, manifest);
    }
}
