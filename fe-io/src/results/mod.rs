//! Results: the HDF5 file and the tables.
