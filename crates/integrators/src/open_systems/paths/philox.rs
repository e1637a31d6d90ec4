//! Random numbers that are functions of a counter: Philox.

/// The multipliers of a round.
const MULTIPLIERS: [u64; 2] = [0xD2E7_470E_E14C_6C93, 0xCA5A_8263_9512_1157];

/// What the key grows by after each round.
const WEYL: [u64; 2] = [0x9E37_79B9_7F4A_7C15, 0xBB67_AE85_84CA_A73B];

const ROUNDS: usize = 10;

/// Returns the four numbers of a counter under a key, of the generator Philox4x64-10. Any two counters or keys give numbers that are
/// independent for all practical purposes, so that nothing has to be drawn in an order.
///
/// Source: Salmon, Moraes, Dror & Shaw, *Parallel random numbers: as easy as 1, 2, 3*, SC'11 (2011).
#[inline]
pub(super) fn philox(mut key: [u64; 2], mut counter: [u64; 4]) -> [u64; 4] {
    for _ in 0..ROUNDS {
        let [a, b, c, d] = counter;
        let [(high_a, low_a), (high_c, low_c)] =
            [product(MULTIPLIERS[0], a), product(MULTIPLIERS[1], c)];
        counter = [high_c ^ b ^ key[0], low_c, high_a ^ d ^ key[1], low_a];
        key = [key[0].wrapping_add(WEYL[0]), key[1].wrapping_add(WEYL[1])];
    }
    counter
}

/// Returns the two halves of a product, the higher one first.
#[inline]
fn product(a: u64, b: u64) -> (u64, u64) {
    let product = u128::from(a) * u128::from(b);
    ((product >> 64) as u64, product as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The known answers of the authors' library Random123.
    #[test]
    fn the_numbers_are_those_of_the_authors() {
        let known = [
            (
                [0; 2],
                [0; 4],
                [
                    0x1655_4D9E_CA36_314C,
                    0xDB20_FE9D_672D_0FDC,
                    0xD7E7_72CE_E186_176B,
                    0x7E68_B68A_EC7B_A23B,
                ],
            ),
            (
                [u64::MAX; 2],
                [u64::MAX; 4],
                [
                    0x87B0_92C3_013F_E90B,
                    0x438C_3C67_BE8D_0224,
                    0x9CC7_D7C6_9CD7_77B6,
                    0xA09C_AEBF_594F_0BA0,
                ],
            ),
        ];
        for (key, counter, numbers) in known {
            assert_eq!(philox(key, counter), numbers);
        }
    }
}
