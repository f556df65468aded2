//! Claims about generation and reproduction.

use refinable_analysis::{Degrees, Stratum};
use refinable_papers::{Bound, ClaimedDegree, Over};

use super::statement::compare;
use super::{Agreement, Finding};

/// Checks a claimed degree against the ladder of the family.
///
/// "For all parameter values" speaks of the generic stratum, where the degree is lowest; "for
/// some" of the highest degree any stratum has.
pub fn check(
    degrees: &Degrees,
    claim: &ClaimedDegree,
    degree: impl Fn(&Stratum) -> usize,
) -> Finding {
    let claimed = claim.value as usize;
    match claim.over {
        Over::All => {
            let found = degree(degrees.generic());
            Finding::new(found.to_string(), compare(claimed, found, claim.bound))
        }
        Over::Some => {
            let best =
                degrees.strata.iter().max_by_key(|s| (degree(s), std::cmp::Reverse(rank(s))));
            let best = best.expect("the generic stratum is always there");
            let found = degree(best);
            let generic = degree(degrees.generic());
            let agreement = if degrees.complete {
                compare(claimed, found, claim.bound)
            } else if claim.bound == Bound::AtLeast && generic >= claimed {
                compare(claimed, generic, claim.bound)
            } else {
                // More may hide in strata that were not computed, and some may have no points.
                Agreement::Undecided
            };
            let place = crate::degrees::condition(&best.locus);
            Finding::new(format!("{found} ({place})"), agreement)
        }
    }
}

/// Prefers the largest stratum among those of the same degree.
fn rank(stratum: &Stratum) -> u32 {
    match stratum.locus {
        refinable_reals::Component::Space => 0,
        refinable_reals::Component::Hypersurface(_) => 1,
        refinable_reals::Component::Point(_) => 2,
    }
}
