//! Work on all the cores of a machine.

/// Does the work on each item with its number, by turns on as many threads as the machine has: neighbors take about as
/// long, those at the ends of an axis may not.
pub(super) fn each<T: Send>(items: impl ExactSizeIterator<Item = T>, work: impl Fn(usize, T) + Sync) {
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get()).min(items.len());
    let mut shares: Vec<Vec<(usize, T)>> = (0..threads).map(|_| Vec::new()).collect();
    for (number, item) in items.enumerate() {
        shares[number % threads].push((number, item));
    }
    let work = &work;
    std::thread::scope(|scope| {
        for share in shares {
            scope.spawn(move || share.into_iter().for_each(|(number, item)| work(number, item)));
        }
    });
}

/// The results of all rows in order.
pub(super) fn rows(count: usize, row: impl Fn(usize) -> Vec<f32> + Sync) -> Vec<f32> {
    let mut results = vec![Vec::new(); count];
    each(results.iter_mut(), |number, result| *result = row(number));
    results.concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_worked_on_once_by_its_number() {
        for count in [0, 1, 2, 3, 17, 1000] {
            let mut items = vec![0usize; count];
            each(items.iter_mut(), |number, item| *item += number + 1);
            assert!(items.iter().enumerate().all(|(number, item)| *item == number + 1), "{count}");
            let all: Vec<f32> = (0..count).flat_map(|row| vec![row as f32; row % 3]).collect();
            assert_eq!(rows(count, |row| vec![row as f32; row % 3]), all);
        }
    }
}
