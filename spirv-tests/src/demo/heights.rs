//! A height image: its texels, how it continues beyond its edges, and its value between texels.

pub use prefilter::gpu::Address;

/// The texel, of `count`, that stands at any whole position.
fn texel(address: Address, at: i64, count: usize) -> usize {
    let count = count as i64;
    let inside = match address {
        Address::Clamp => at.clamp(0, count - 1),
        Address::Repeat => at.rem_euclid(count),
        Address::Mirror => {
            let folded = at.rem_euclid(2 * count);
            folded.min(2 * count - 1 - folded)
        }
    };
    inside as usize
}

/// Heights in [0, 1] on a grid of texels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    /// Texels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The heights.
    pub texels: Vec<f32>,
    /// What lies beyond the edges.
    pub address: Address,
}

impl Heights {
    /// Reads a gray PNG of 8 or 16 bits. Its smallest and largest values become 0 and 1 if `stretch`, else 0 and the
    /// largest storable value.
    ///
    /// An error is the decoder's.
    pub fn from_png(png: &[u8], stretch: bool, address: Address) -> Result<Self, image::ImageError> {
        let gray = image::load_from_memory_with_format(png, image::ImageFormat::Png)?.into_luma16();
        let (width, height) = (gray.width() as usize, gray.height() as usize);
        let values = gray.into_raw();
        let (low, high) = match (values.iter().min(), values.iter().max()) {
            (Some(&low), Some(&high)) if stretch && high > low => (f64::from(low), f64::from(high)),
            _ => (0.0, f64::from(u16::MAX)),
        };
        let texels = values.iter().map(|&value| ((f64::from(value) - low) / (high - low)) as f32).collect();
        Ok(Self { width, height, texels, address })
    }

    /// The bilinear height at a position in texture coordinates: texel i of n has its center at (i + ½)/n.
    pub fn bilinear(&self, position: [f64; 2]) -> f64 {
        let (x, y) = (position[0] * self.width as f64 - 0.5, position[1] * self.height as f64 - 0.5);
        let (left, top) = (x.floor(), y.floor());
        let (across, down) = (x - left, y - top);
        let columns = [0, 1].map(|step| texel(self.address, left as i64 + step, self.width));
        let rows = [0, 1].map(|step| texel(self.address, top as i64 + step, self.height) * self.width);
        let [upper, lower] = rows.map(|row| {
            let [from, to] = columns.map(|column| f64::from(self.texels[row + column]));
            from + across * (to - from)
        });
        upper + down * (lower - upper)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(address: Address) -> Heights {
        Heights { width: 3, height: 2, texels: vec![0.0, 0.25, 0.5, 0.5, 0.75, 1.0], address }
    }

    #[test]
    fn texel_centers_return_the_texels_and_edges_follow_the_address() {
        let center = |column: f64, row: f64| [(column + 0.5) / 3.0, (row + 0.5) / 2.0];
        for (address, left, above) in
            [(Address::Repeat, 0.5, 0.5), (Address::Mirror, 0.0, 0.0), (Address::Clamp, 0.0, 0.0)]
        {
            let heights = ramp(address);
            for (number, &texel) in heights.texels.iter().enumerate() {
                let at = center((number % 3) as f64, (number / 3) as f64);
                assert!((heights.bilinear(at) - f64::from(texel)).abs() < 1e-12);
            }
            assert!((heights.bilinear(center(-1.0, 0.0)) - left).abs() < 1e-12, "{address:?}");
            assert!((heights.bilinear(center(0.0, -1.0)) - above).abs() < 1e-12, "{address:?}");
            assert!((heights.bilinear(center(0.6, 0.3)) - 0.3).abs() < 1e-12);
        }
    }

    #[test]
    fn the_mirror_turns_at_both_edges() {
        let walk: Vec<usize> = (-4..8).map(|at| texel(Address::Mirror, at, 3)).collect();
        assert_eq!(walk, [2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1]);
    }
}
