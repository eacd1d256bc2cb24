// What native_drawings draws where it is given no scene.
export const models = ['house', 'clevis', 'torus', 'ring', 'crossing', 'terrain', 'city', 'stairs', 'spring', 'shards'];
// The files that it writes: those that are models, and those that are refused.
export const files = ['house.obj', 'city.ply', 'ring.stl', 'roof.off'];
export const refusedFiles = ['corner.obj', 'word.obj', 'short.ply', 'short.stl', 'picture.stl', 'empty.obj', 'nothing.off'];
