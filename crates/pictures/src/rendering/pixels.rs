//! Pixels of drawings with images of cells.

use crate::error::PictureError;
use resvg::tiny_skia::{FilterQuality, Paint, Pattern, Pixmap, Rect, SpreadMode, Transform};
use usvg::{Group, Image, ImageKind, ImageRendering, Node, Path};

/// Draws what is in a group with images, with the transform of its contents. Images are drawn here: the library draws
/// them only with decoders of all formats, which take long to compile.
pub(super) fn draw(
    group: &Group,
    transform: Transform,
    pixels: &mut Pixmap,
) -> Result<(), PictureError> {
    for node in group.children() {
        match (node, node.abs_layer_bounding_box()) {
            (Node::Image(image), _) if is_raster(image) => draw_image(image, transform, pixels)?,
            (Node::Group(group), _) if has_images(group) => {
                if group.should_isolate() {
                    return Err(invalid("an image is clipped, masked, filtered or translucent"));
                }
                draw(group, transform.pre_concat(group.transform()), pixels)?;
            }
            (node, Some(place)) => {
                // The library moves the corner of the node to the origin.
                let transform = transform.pre_translate(place.x(), place.y());
                resvg::render_node(node, transform, &mut pixels.as_mut());
            }
            (Node::Path(path), None) => draw_line(path, transform, pixels)?,
            (_, None) => {}
        }
    }
    Ok(())
}

/// Draws a line along an axis. It has no area, and so the library does not draw it alone.
fn draw_line(path: &Path, transform: Transform, pixels: &mut Pixmap) -> Result<(), PictureError> {
    let Some(stroke) = path.stroke().filter(|_| path.is_visible()) else { return Ok(()) };
    let usvg::Paint::Color(colour) = stroke.paint() else {
        return Err(invalid("a line along an axis, beside an image, has more than a colour"));
    };
    let mut paint = Paint::default();
    paint.set_color_rgba8(colour.red, colour.green, colour.blue, stroke.opacity().to_u8());
    paint.anti_alias = path.rendering_mode().use_shape_antialiasing();
    pixels.stroke_path(path.data(), &paint, &stroke.to_tiny_skia(), transform, None);
    Ok(())
}

/// Returns whether there are images in a group that are not themselves drawings.
pub(super) fn has_images(group: &Group) -> bool {
    group.children().iter().any(|node| match node {
        Node::Group(group) => has_images(group),
        Node::Image(image) => is_raster(image),
        _ => false,
    })
}

fn is_raster(image: &Image) -> bool {
    !matches!(image.kind(), ImageKind::SVG(_))
}

fn draw_image(
    image: &Image,
    transform: Transform,
    pixels: &mut Pixmap,
) -> Result<(), PictureError> {
    let ImageKind::PNG(data) = image.kind() else { return Err(invalid("an image is no PNG")) };
    let cells = Pixmap::decode_png(data).map_err(invalid)?;
    let [width, height] = [cells.width() as f32, cells.height() as f32];
    let (true, Some(area)) = (image.is_visible(), Rect::from_xywh(0.0, 0.0, width, height)) else {
        return Ok(());
    };
    let quality = match image.rendering_mode() {
        ImageRendering::OptimizeQuality | ImageRendering::HighQuality => FilterQuality::Bicubic,
        ImageRendering::Smooth => FilterQuality::Bilinear,
        _ => FilterQuality::Nearest,
    };
    let shader = Pattern::new(cells.as_ref(), SpreadMode::Pad, quality, 1.0, Transform::identity());
    pixels.fill_rect(area, &Paint { shader, ..Paint::default() }, transform, None);
    Ok(())
}

pub(super) fn invalid(reason: impl ToString) -> PictureError {
    PictureError::Svg { reason: reason.to_string() }
}
