package dev.cairn.render.app;

/**
 * What a ray from the camera hits first.
 *
 * @param entity whose model it is
 * @param distance along the ray, m
 * @param localX the point in the entity's frame, m
 * @param localY same
 * @param localZ same
 */
public record Pick(long entity, double distance, double localX, double localY, double localZ) {}
