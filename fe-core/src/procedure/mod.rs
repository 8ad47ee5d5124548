//! Procedures: from one converged state to the next.
