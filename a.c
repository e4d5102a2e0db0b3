__attribute__((section(".cgw_config"), aligned(8), used)) const unsigned char reserved[8192] = {0};
__attribute__((section(".small"), aligned(8), used)) const unsigned char small[64] = {0};
__attribute__((section(".odd"), aligned(8), used)) const unsigned char odd[8192] = {1};
__attribute__((section(".wr"), aligned(8), used)) unsigned char wr[8192] = {0};
__attribute__((section(".cd,\"ax\",@progbits#"), aligned(8), used)) const unsigned char cd[8192] = {0};
unsigned char b[8192];
int main(void){return b[0];}
