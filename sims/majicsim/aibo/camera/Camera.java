package majicsim.aibo.camera;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.DoubleSupplier;
import majicsim.aibo.urbi.Kernel;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/**
 * The camera and the ball tracking behind it (URBI sheet, sections 12 and 13). It takes 30 pictures a second, of which
 * only those are computed that a client requests; settings take effect from the next cycle on. There is no ball in the
 * lab.
 */
public final class Camera {
    private static final double PICTURE_MS = 1000.0 / 30;

    /** The position that the ball tracking reports without a ball. */
    private static final double NOWHERE = -1;

    private final CameraLens lens;
    private final Kernel kernel;
    private final Map<String, Variable> fields = new LinkedHashMap<>();
    private CameraSettings settings = CameraSettings.DEFAULT;
    private @Nullable Shot last;

    public Camera(CameraLens lens, Kernel kernel) {
        this.lens = lens;
        this.kernel = kernel;
    }

    public void install() {
        put("camera.val", () -> settings.isJpeg() ? jpeg() : raw());
        put("camera.raw", this::raw);
        CameraSettings start = CameraSettings.DEFAULT;
        field("format", start.format(), 0, 1);
        field("resolution", start.resolution(), 0, 2);
        field("jpegfactor", start.jpegFactor(), 0, 100);
        field("shutter", start.shutter(), 1, 3);
        field("gain", start.gain(), 1, 3);
        field("wb", start.whiteBalance(), 1, 3);
        field("reconstruct", 0, 0, 1);
        number("camera.width", () -> settings.width());
        number("camera.height", () -> settings.height());
        number("camera.xfov", () -> CameraLens.XFOV_DEG);
        number("camera.yfov", () -> CameraLens.YFOV_DEG);
        number("ball.visible", () -> 0);
        number("ball.x", () -> NOWHERE);
        number("ball.y", () -> NOWHERE);
        number("ball.ratio", () -> 0);
    }

    /** To be called once a kernel cycle. */
    public void cycle() {
        settings = new CameraSettings(
                get("format"), get("resolution"), get("jpegfactor"), get("shutter"), get("gain"), get("wb"));
    }

    /** The kernel repeats the last parameter of pictures that it makes itself (sheet, section 12). */
    private Value jpeg() {
        return binary("jpeg", shot().picture().jpeg(settings.jpegFactor()));
    }

    private Value raw() {
        return binary("YCbCr", shot().picture().yCbCr());
    }

    private Value binary(String type, String bytes) {
        String size = settings.width() + " " + settings.height() + " " + settings.height();
        return new Value.Binary(bytes, type + " " + size);
    }

    private Shot shot() {
        long number = (long) Math.floor(kernel.nowMs() / PICTURE_MS);
        Shot shot = last;
        if (shot == null || shot.number() != number || !shot.settings().equals(settings)) {
            shot = new Shot(number, settings, lens.take(settings));
            last = shot;
        }
        return shot;
    }

    private void field(String name, double start, double min, double max) {
        Variable variable = new Variable("camera." + name, Value.of(start));
        variable.limit(min, max);
        fields.put(name, variable);
        kernel.memory().variables().put(variable);
    }

    private int get(String name) {
        Variable field = Objects.requireNonNull(fields.get(name), name);
        return field.target() instanceof Value.Num num ? (int) num.number() : 0;
    }

    private void number(String name, DoubleSupplier reading) {
        put(name, () -> Value.of(reading.getAsDouble()));
    }

    private void put(String name, Variable.Hardware hardware) {
        kernel.memory().variables().put(new Variable(name, Value.VOID, hardware));
    }

    private record Shot(long number, CameraSettings settings, Picture picture) {}
}
