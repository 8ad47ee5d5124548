//! Blocks of like solid elements: the term, stresses and strains.
