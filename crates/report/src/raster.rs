//! Pictures in pixels.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

/// Pixels for each unit of the picture.
const SCALE: f32 = 2.0;

/// The only fonts, so that the same picture gives the same pixels on every machine.
static FONTS: LazyLock<Arc<fontdb::Database>> = LazyLock::new(|| {
    let mut fonts = fontdb::Database::new();
    for font in [dejavu::sans::regular(), dejavu::sans::bold()] {
        fonts.load_font_data(font.to_vec());
    }
    fonts.set_sans_serif_family("DejaVu Sans");
    Arc::new(fonts)
});

/// An SVG picture as PNG, two pixels for each unit, text in DejaVu Sans.
///
/// # Panics
/// If the text is not one of the pictures of this crate, each of which is well-formed and not empty.
#[must_use]
pub fn png(svg: &str) -> Vec<u8> {
    let options = Options { fontdb: FONTS.clone(), ..Options::default() };
    let tree = Tree::from_str(svg, &options).expect("our pictures are well-formed");
    let [width, height] = [tree.size().width(), tree.size().height()].map(|x| x * SCALE);
    let mut pixels =
        Pixmap::new(width.ceil() as u32, height.ceil() as u32).expect("our pictures are not empty");
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels.encode_png().expect("pixels can be written as PNG")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dark(svg: &str) -> usize {
        let pixels = Pixmap::decode_png(&png(svg)).unwrap();
        assert_eq!((pixels.width(), pixels.height()), (80, 40));
        pixels.pixels().iter().filter(|p| p.red() < 128).count()
    }

    /// A misnamed font leaves nothing but the background.
    #[test]
    fn text_is_drawn() {
        let picture = |text: &str, weight: &str| {
            format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 40 20\" \
                 font-family=\"sans-serif\"><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\
                 <text x=\"5\" y=\"15\" font-weight=\"{weight}\">{text}</text></svg>"
            )
        };
        assert_eq!(dark(&picture("", "normal")), 0);
        for text in ["C³", "α", "β", "0"] {
            let [thin, bold] = ["normal", "bold"].map(|weight| dark(&picture(text, weight)));
            assert!(0 < thin && thin < bold, "{text}: {thin}, {bold}");
        }
    }
}
