//! The multifrontal Cholesky factorisation.
