package troupe.scene.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.scene.SceneTexts;
import troupe.scene.check.SceneChecks;

/** Damages valid files by the thousand: nothing but the declared exception may come out. */
class SceneMutationTest {
    private static final long SEED = Long.getLong("troupe.seed", 20_260_101);
    private static final int ROUNDS = 10_000;
    private static final String[] TOKENS = {
        "NaN",
        "1e308",
        "-1e308",
        "Infinity",
        "-0",
        "1e-320",
        "",
        "999999999999999999999",
        "<",
        ">",
        "\"",
        "&#0;",
        "<!DOCTYPE a>",
        "&lol;",
        "\u0000",
        "movable=\"maybe\"",
        "points=\"0,0\"",
        "id=\"south-wall\"",
        "]]>",
        "<walk/>"
    };

    @Test
    void onlyDeclaredErrorsComeOfDamagedFiles() throws IOException {
        byte[][] files = SceneTexts.samples().map(SceneMutationTest::bytes).toArray(byte[][]::new);
        Random random = new Random(SEED);
        int read = 0;
        for (int round = 0; round < ROUNDS; round++) {
            byte[] damaged = damaged(files[random.nextInt(files.length)], random);
            try {
                SceneSource source = SceneXml.read(new ByteArrayInputStream(damaged), "damaged.xml");
                SceneChecks.check(source.scene(), source.lines())
                        .forEach(p -> assertFalse(p.message().isBlank()));
                assertEquals(
                        source.scene(),
                        SceneTexts.read(SceneXml.write(source.scene())),
                        () -> "seed " + SEED + " gave a scene that does not survive writing");
                read++;
            } catch (SceneException e) {
                assertFalse(e.getMessage().contains("\n"), e.getMessage());
            } catch (RuntimeException | StackOverflowError e) {
                fail("seed " + SEED + ", round " + round + ":\n" + new String(damaged, StandardCharsets.UTF_8), e);
            }
        }
        assertTrue(read > ROUNDS / 20, "only " + read + " files could still be read: the damage is too coarse");
    }

    private static byte[] bytes(Path file) {
        try {
            return Files.readAllBytes(file);
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private static byte[] damaged(byte[] file, Random random) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int at = random.nextInt(file.length);
        int other = Math.min(file.length, at + random.nextInt(40));
        out.write(file, 0, at);
        switch (random.nextInt(6)) {
            case 0 -> out.write(random.nextInt(256));
            case 1 -> out.writeBytes(TOKENS[random.nextInt(TOKENS.length)].getBytes(StandardCharsets.UTF_8));
            case 2 -> out.write('0' + random.nextInt(10));
            case 3 -> other = random.nextInt(4) == 0 ? file.length : other;
            case 4 -> out.write(file, at, other - at);
            default -> {
                out.writeBytes(TOKENS[random.nextInt(TOKENS.length)].getBytes(StandardCharsets.UTF_8));
                other = Math.min(file.length, at + 1);
            }
        }
        int rest = out.size() == at && other > at ? other : Math.min(file.length, Math.max(other, at + 1));
        out.write(file, rest, file.length - rest);
        return out.toByteArray();
    }
}
