#version 450 core
// item_buffer: one layer of line IDs.
//
// A layer leaves out the IDs of the layers before it. Peeling by depth would not do: lines that meet have
// the same depth there, so all but one of them would be peeled away at once.

uniform int layer;
uniform usampler2D first_layer;
uniform usampler2D second_layer;

flat in uint line_id;

layout(location = 0) out uint id;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    if (layer > 0 && texelFetch(first_layer, texel, 0).r == line_id) discard;
    if (layer > 1 && texelFetch(second_layer, texel, 0).r == line_id) discard;
    id = line_id;
}
