//! Pixels of drawings with images of cells.

use crate::error::PictureError;
use resvg::tiny_skia::{FilterQuality, Paint, Pattern, Pixmap, Rect, SpreadMode, Transform};
use usvg::{Group, Image, ImageKind, ImageRendering, Node};

/// Draws what is in a group. Images are drawn here: the library draws them only with decoders of all formats, which
/// take long to compile.
pub(super) fn draw(
    group: &Group,
    transform: Transform,
    pixels: &mut Pixmap,
) -> Result<(), PictureError> {
    for node in group.children() {
        match node {
            Node::Image(image) if is_raster(image) => draw_image(image, transform, pixels)?,
            Node::Group(group) if has_images(group) => {
                if group.should_isolate() {
                    return Err(invalid("an image is clipped, masked, filtered or translucent"));
                }
                draw(group, transform, pixels)?;
            }
            node => {
                // The library moves the node to the corner of the pixels; what has no box is not visible.
                if let Some(place) = node.abs_layer_bounding_box() {
                    let transform = transform.pre_translate(place.x(), place.y());
                    resvg::render_node(node, transform, &mut pixels.as_mut());
                }
            }
        }
    }
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
    let transform = transform.pre_concat(image.abs_transform());
    pixels.fill_rect(area, &Paint { shader, ..Paint::default() }, transform, None);
    Ok(())
}

pub(super) fn invalid(reason: impl ToString) -> PictureError {
    PictureError::Svg { reason: reason.to_string() }
}
