typedef struct ToyParameters {
    la_uint count;
    float factor;
} ToyParameters;
#define toy_tables(in, out, inout, unordered) in(float, values)out(float, multiples)
