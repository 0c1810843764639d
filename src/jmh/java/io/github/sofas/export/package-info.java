/** Benchmarks of the kernels. */
package io.github.sofas.export;
