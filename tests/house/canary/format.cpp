// bites: [-Wclang-format-violations]
namespace mayfly {
int   crooked( int a ){ return a ;}
}
