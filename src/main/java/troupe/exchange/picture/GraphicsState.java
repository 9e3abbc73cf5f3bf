package troupe.exchange.picture;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Paint;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Area;
import java.awt.image.BufferedImage;
import java.util.Map;

/**
 * Keeps the state of a {@link Graphics2D}: transform, clip, colour, stroke, font, composite and hints.
 */
abstract class GraphicsState extends Graphics2D {
    private final Graphics2D measure;
    private AffineTransform transform = new AffineTransform();
    private Area clip;
    private Color color = Color.BLACK;
    private Color background = Color.WHITE;
    private Stroke stroke = new BasicStroke();
    private Composite composite = AlphaComposite.SrcOver;
    private Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private RenderingHints hints = new RenderingHints(Map.of());

    /** Makes graphics of the default state, with fonts measured as on an image. */
    GraphicsState() {
        measure = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
    }

    /** Makes graphics in the state of another. */
    GraphicsState(GraphicsState other) {
        measure = other.measure;
        copyState(other);
    }

    private static RenderingHints copy(RenderingHints hints) {
        RenderingHints copy = new RenderingHints(Map.of());
        copy.putAll(hints);
        return copy;
    }

    private void copyState(GraphicsState other) {
        transform = new AffineTransform(other.transform);
        clip = other.clip;
        color = other.color;
        background = other.background;
        stroke = other.stroke;
        composite = other.composite;
        font = other.font;
        hints = copy(other.hints);
    }

    /** Returns the clip in the units of the output, null for none. */
    Area outputClip() {
        return clip;
    }

    /** Returns the opacity of the composite. */
    float opacity() {
        return composite instanceof AlphaComposite alpha ? alpha.getAlpha() : 1;
    }

    @Override
    public void translate(int x, int y) {
        transform.translate(x, y);
    }

    @Override
    public void translate(double x, double y) {
        transform.translate(x, y);
    }

    @Override
    public void rotate(double angle) {
        transform.rotate(angle);
    }

    @Override
    public void rotate(double angle, double x, double y) {
        transform.rotate(angle, x, y);
    }

    @Override
    public void scale(double x, double y) {
        transform.scale(x, y);
    }

    @Override
    public void shear(double x, double y) {
        transform.shear(x, y);
    }

    @Override
    public void transform(AffineTransform other) {
        transform.concatenate(other);
    }

    @Override
    public void setTransform(AffineTransform other) {
        transform = new AffineTransform(other);
    }

    @Override
    public AffineTransform getTransform() {
        return new AffineTransform(transform);
    }

    @Override
    public Color getColor() {
        return color;
    }

    @Override
    public void setColor(Color other) {
        color = other == null ? color : other;
    }

    @Override
    public Paint getPaint() {
        return color;
    }

    @Override
    public void setPaint(Paint paint) {
        if (!(paint instanceof Color c)) {
            throw unsupported("paint but plain colours");
        }
        color = c;
    }

    @Override
    public void setPaintMode() {
        composite = AlphaComposite.SrcOver;
    }

    @Override
    public void setXORMode(Color other) {
        throw unsupported("XOR mode");
    }

    @Override
    public Stroke getStroke() {
        return stroke;
    }

    @Override
    public void setStroke(Stroke other) {
        stroke = other;
    }

    @Override
    public Composite getComposite() {
        return composite;
    }

    @Override
    public void setComposite(Composite other) {
        composite = other;
    }

    @Override
    public Color getBackground() {
        return background;
    }

    @Override
    public void setBackground(Color other) {
        background = other;
    }

    @Override
    public Font getFont() {
        return font;
    }

    @Override
    public void setFont(Font other) {
        font = other == null ? font : other;
    }

    @Override
    public FontMetrics getFontMetrics(Font other) {
        return measure.getFontMetrics(other);
    }

    @Override
    public FontRenderContext getFontRenderContext() {
        return new FontRenderContext(null, true, true);
    }

    @Override
    public GraphicsConfiguration getDeviceConfiguration() {
        return measure.getDeviceConfiguration();
    }

    @Override
    public void setRenderingHint(RenderingHints.Key key, Object value) {
        hints.put(key, value);
    }

    @Override
    public Object getRenderingHint(RenderingHints.Key key) {
        return hints.get(key);
    }

    @Override
    public void setRenderingHints(Map<?, ?> others) {
        hints = new RenderingHints(Map.of());
        hints.putAll(others);
    }

    @Override
    public void addRenderingHints(Map<?, ?> others) {
        hints.putAll(others);
    }

    @Override
    public RenderingHints getRenderingHints() {
        return copy(hints);
    }

    @Override
    public void clip(Shape shape) {
        Area area = new Area(transform.createTransformedShape(shape));
        if (clip != null) {
            area.intersect(clip);
        }
        clip = area;
    }

    @Override
    public void clipRect(int x, int y, int width, int height) {
        clip(new Rectangle(x, y, width, height));
    }

    @Override
    public void setClip(int x, int y, int width, int height) {
        setClip(new Rectangle(x, y, width, height));
    }

    @Override
    public void setClip(Shape shape) {
        clip = shape == null ? null : new Area(transform.createTransformedShape(shape));
    }

    @Override
    public Shape getClip() {
        return clip == null ? null : inverse().createTransformedShape(clip);
    }

    @Override
    public Rectangle getClipBounds() {
        return clip == null ? null : getClip().getBounds();
    }

    private AffineTransform inverse() {
        AffineTransform inverse = new AffineTransform(transform);
        try {
            inverse.invert();
        } catch (java.awt.geom.NoninvertibleTransformException e) {
            throw new IllegalStateException("a transform that flattens the picture: " + transform, e);
        }
        return inverse;
    }

    /** Makes the refusal of what a vector format cannot hold. */
    static UnsupportedOperationException unsupported(String what) {
        return new UnsupportedOperationException("vector graphics hold no " + what);
    }
}
