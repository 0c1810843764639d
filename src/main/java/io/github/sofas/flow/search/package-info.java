/**
 * Finds new structures among the events that no track plane takes. Open {@link io.github.sofas.flow.search.FlowPlane}
 * first, then {@link io.github.sofas.flow.search.StructureSearch}.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.search;
