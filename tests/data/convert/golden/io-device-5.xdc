<?xml version="1.0" encoding="UTF-8"?>
<ISO15745ProfileContainer xmlns="http://www.canopen.org/xml/1.1" xmlns:co="http://www.canopen.org/xml/1.1" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
  <ISO15745Profile>
    <ProfileHeader xmlns="">
      <ProfileIdentification>CANopen device profile</ProfileIdentification>
      <ProfileRevision>1.1</ProfileRevision>
      <ProfileName></ProfileName>
      <ProfileSource></ProfileSource>
      <ProfileClassID>Device</ProfileClassID>
      <ISO15745Reference>
        <ISO15745Part>1</ISO15745Part>
        <ISO15745Edition>1</ISO15745Edition>
        <ProfileTechnology>CANopen</ProfileTechnology>
      </ISO15745Reference>
    </ProfileHeader>
    <ProfileBody xmlns="" xsi:type="co:ProfileBody_Device_CANopen" formatName="CANopen" formatVersion="1.0" fileName="io-device.eds" fileCreator="cgw" fileCreationDate="2026-03-01" fileCreationTime="09:30:00" fileModifiedBy="cgw" fileModificationDate="2026-03-02" fileModificationTime="12:00:00" fileVersion="2.1" supportedLanguages="en">
      <co:DeviceIdentity>
        <co:vendorName>Maker of Tests</co:vendorName>
        <co:vendorID>0x000003FF</co:vendorID>
        <co:productName>IO Device</co:productName>
        <co:productID>0x00000011</co:productID>
        <co:productText>
          <description lang="en">Inputs and outputs for tests</description>
        </co:productText>
        <co:orderNumber>IO-11</co:orderNumber>
        <co:version versionType="FW">0x00010002</co:version>
      </co:DeviceIdentity>
      <co:DeviceManager/>
      <co:DeviceFunction>
        <co:capabilities>
          <co:characteristicsList>
            <co:characteristic>
              <co:characteristicName>
                <label lang="en">Protocol</label>
              </co:characteristicName>
              <co:characteristicContent>
                <label lang="en">CANopen</label>
              </co:characteristicContent>
            </co:characteristic>
            <co:characteristic>
              <co:characteristicName>
                <label lang="en">Comments</label>
              </co:characteristicName>
              <co:characteristicContent>
                <label lang="en">Written for the tests of cgw</label>
              </co:characteristicContent>
            </co:characteristic>
          </co:characteristicsList>
        </co:capabilities>
      </co:DeviceFunction>
      <co:ApplicationProcess>
        <co:parameterList>
          <co:parameter uniqueID="UID_OBJ_1000" access="read">
            <label lang="en">Device Type</label>
            <UDINT/>
            <co:actualValue value="0x00000191"/>
            <co:defaultValue value="0x00000191"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_1001" access="read">
            <label lang="en">Error Register</label>
            <USINT/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_1008" access="const">
            <label lang="en">Device Name</label>
            <STRING/>
            <co:actualValue value="IO Device"/>
            <co:defaultValue value="IO Device"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_100C" access="readWrite">
            <label lang="en">Guard Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x0000"/>
                <maxValue value="0x7FFF"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_1014" access="readWrite">
            <label lang="en">COB-ID EMCY</label>
            <UDINT/>
            <co:actualValue value="0x00000085"/>
            <co:defaultValue value="0x00000085"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_1017" access="readWrite">
            <label lang="en">Producer Heartbeat Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101800" access="read">
            <label lang="en">Highest Sub-Index</label>
            <USINT/>
            <co:actualValue value="0x04"/>
            <co:defaultValue value="0x04"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101801" access="read">
            <label lang="en">Vendor</label>
            <UDINT/>
            <co:actualValue value="0x000003FF"/>
            <co:defaultValue value="0x000003FF"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101802" access="read">
            <label lang="en">Product</label>
            <UDINT/>
            <co:actualValue value="0x00000011"/>
            <co:defaultValue value="0x00000011"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101803" access="read">
            <label lang="en">Revision</label>
            <UDINT/>
            <co:actualValue value="0x00010002"/>
            <co:defaultValue value="0x00010002"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101804" access="read">
            <label lang="en">Serial Number</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140000" access="read">
            <label lang="en">Highest Sub-Index</label>
            <USINT/>
            <co:actualValue value="0x02"/>
            <co:defaultValue value="0x02"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140001" access="readWrite">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x00000205"/>
            <co:defaultValue value="0x00000205"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140002" access="readWrite">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFF"/>
            <co:defaultValue value="0xFF"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160000" access="readWrite">
            <label lang="en">Number of Mapped Objects</label>
            <USINT/>
            <co:actualValue value="0x01"/>
            <co:defaultValue value="0x01"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160001" access="readWrite">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x62000108"/>
            <co:defaultValue value="0x62000108"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160002" access="readWrite">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180000" access="read">
            <label lang="en">Highest Sub-Index</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180001" access="readWrite">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x00000185"/>
            <co:defaultValue value="0x00000185"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180002" access="readWrite">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFF"/>
            <co:defaultValue value="0xFF"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180005" access="readWrite">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0000" access="readWrite">
            <label lang="en">Number of Mapped Objects</label>
            <USINT/>
            <co:actualValue value="0x01"/>
            <co:defaultValue value="0x01"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0001" access="readWrite">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x60000108"/>
            <co:defaultValue value="0x60000108"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0002" access="readWrite">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2000" access="readWrite">
            <label lang="en">Gain</label>
            <REAL/>
            <co:actualValue value="1.5"/>
            <co:defaultValue value="1.5"/>
            <co:allowedValues>
              <co:range>
                <minValue value="-2.5"/>
                <maxValue value="1000000"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2001" access="readWriteInput">
            <label lang="en">Offset</label>
            <INT/>
            <co:defaultValue value="-5"/>
            <co:allowedValues>
              <co:range>
                <minValue value="-100"/>
                <maxValue value="0x0064"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2002" access="readWrite">
            <label lang="en">Calibration</label>
            <BITSTRING/>
            <co:actualValue value="00FF10AB"/>
            <co:defaultValue value="00FF10AB"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2003" access="write">
            <label lang="en">Firmware</label>
            <BITSTRING/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2004" access="read">
            <label lang="en">Counter</label>
            <ULINT/>
            <co:actualValue value="0xFFFFFFFFFFFFFFFF"/>
            <co:defaultValue value="0xFFFFFFFFFFFFFFFF"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2005" access="readWrite">
            <label lang="en">Trim</label>
            <BITSTRING/>
            <co:actualValue value="-1"/>
            <co:defaultValue value="-1"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_600000" access="read">
            <label lang="en">Highest Sub-Index</label>
            <USINT/>
            <co:actualValue value="0x02"/>
            <co:defaultValue value="0x02"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_600001" access="read">
            <label lang="en">Inputs 1 to 8</label>
            <USINT/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_600002" access="read">
            <label lang="en">Inputs 9 to 16</label>
            <USINT/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_620000" access="read">
            <label lang="en">Highest Sub-Index</label>
            <USINT/>
            <co:actualValue value="0x01"/>
            <co:defaultValue value="0x01"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_620001" access="readWriteOutput">
            <label lang="en">Outputs 1 to 8</label>
            <USINT/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
        </co:parameterList>
      </co:ApplicationProcess>
    </ProfileBody>
  </ISO15745Profile>
  <ISO15745Profile>
    <ProfileHeader xmlns="">
      <ProfileIdentification>CANopen communication network profile</ProfileIdentification>
      <ProfileRevision>1.1</ProfileRevision>
      <ProfileName></ProfileName>
      <ProfileSource></ProfileSource>
      <ProfileClassID>CommunicationNetwork</ProfileClassID>
      <ISO15745Reference>
        <ISO15745Part>1</ISO15745Part>
        <ISO15745Edition>1</ISO15745Edition>
        <ProfileTechnology>CANopen</ProfileTechnology>
      </ISO15745Reference>
    </ProfileHeader>
    <ProfileBody xmlns="" xsi:type="co:ProfileBody_CommunicationNetwork_CANopen" formatName="CANopen" formatVersion="1.0" fileName="io-device.eds" fileCreator="cgw" fileCreationDate="2026-03-01" fileCreationTime="09:30:00" fileModifiedBy="cgw" fileModificationDate="2026-03-02" fileModificationTime="12:00:00" fileVersion="2.1" supportedLanguages="en">
      <ApplicationLayers>
        <co:CANopenObjectList mandatoryObjects="3" optionalObjects="10" manufacturerObjects="6">
          <CANopenObject index="1000" name="Device Type" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000191" actualValue="0x00000191" PDOmapping="no" uniqueIDRef="UID_OBJ_1000"/>
          <CANopenObject index="1001" name="Error Register" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" PDOmapping="TPDO" uniqueIDRef="UID_OBJ_1001"/>
          <CANopenObject index="1008" name="Device Name" objectType="7" dataType="0009" accessType="const" defaultValue="IO Device" actualValue="IO Device" PDOmapping="no" uniqueIDRef="UID_OBJ_1008"/>
          <CANopenObject index="100C" name="Guard Time" objectType="7" dataType="0006" lowLimit="0x0000" highLimit="0x7FFF" accessType="rw" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_OBJ_100C"/>
          <CANopenObject index="1014" name="COB-ID EMCY" objectType="7" dataType="0007" accessType="rw" defaultValue="0x00000085" actualValue="0x00000085" PDOmapping="no" uniqueIDRef="UID_OBJ_1014"/>
          <CANopenObject index="1017" name="Producer Heartbeat Time" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_OBJ_1017"/>
          <CANopenObject index="1018" name="Identity" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Highest Sub-Index" objectType="7" dataType="0005" accessType="ro" defaultValue="0x04" actualValue="0x04" PDOmapping="no" uniqueIDRef="UID_SUB_101800"/>
            <CANopenSubObject subIndex="01" name="Vendor" objectType="7" dataType="0007" accessType="ro" defaultValue="0x000003FF" actualValue="0x000003FF" PDOmapping="no" uniqueIDRef="UID_SUB_101801"/>
            <CANopenSubObject subIndex="02" name="Product" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000011" actualValue="0x00000011" PDOmapping="no" uniqueIDRef="UID_SUB_101802"/>
            <CANopenSubObject subIndex="03" name="Revision" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00010002" actualValue="0x00010002" PDOmapping="no" uniqueIDRef="UID_SUB_101803"/>
            <CANopenSubObject subIndex="04" name="Serial Number" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_101804"/>
          </CANopenObject>
          <CANopenObject index="1400" name="Receive PDO 1" objectType="9" subNumber="3">
            <CANopenSubObject subIndex="00" name="Highest Sub-Index" objectType="7" dataType="0005" accessType="ro" defaultValue="0x02" actualValue="0x02" PDOmapping="no" uniqueIDRef="UID_SUB_140000"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="rw" defaultValue="0x00000205" actualValue="0x00000205" PDOmapping="no" uniqueIDRef="UID_SUB_140001"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="rw" defaultValue="0xFF" actualValue="0xFF" PDOmapping="no" uniqueIDRef="UID_SUB_140002"/>
          </CANopenObject>
          <CANopenObject index="1600" name="Receive PDO 1 Mapping" objectType="9" subNumber="3">
            <CANopenSubObject subIndex="00" name="Number of Mapped Objects" objectType="7" dataType="0005" accessType="rw" defaultValue="0x01" actualValue="0x01" PDOmapping="no" uniqueIDRef="UID_SUB_160000"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="rw" defaultValue="0x62000108" actualValue="0x62000108" PDOmapping="no" uniqueIDRef="UID_SUB_160001"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="rw" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160002"/>
          </CANopenObject>
          <CANopenObject index="1800" name="Transmit PDO 1" objectType="9" subNumber="4">
            <CANopenSubObject subIndex="00" name="Highest Sub-Index" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180000"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="rw" defaultValue="0x00000185" actualValue="0x00000185" PDOmapping="no" uniqueIDRef="UID_SUB_180001"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="rw" defaultValue="0xFF" actualValue="0xFF" PDOmapping="no" uniqueIDRef="UID_SUB_180002"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180005"/>
          </CANopenObject>
          <CANopenObject index="1A00" name="Transmit PDO 1 Mapping" objectType="9" subNumber="3">
            <CANopenSubObject subIndex="00" name="Number of Mapped Objects" objectType="7" dataType="0005" accessType="rw" defaultValue="0x01" actualValue="0x01" PDOmapping="no" uniqueIDRef="UID_SUB_1A0000"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="rw" defaultValue="0x60000108" actualValue="0x60000108" PDOmapping="no" uniqueIDRef="UID_SUB_1A0001"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="rw" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0002"/>
          </CANopenObject>
          <CANopenObject index="2000" name="Gain" objectType="7" dataType="0008" lowLimit="-2.5" highLimit="1000000" accessType="rw" defaultValue="1.5" actualValue="1.5" PDOmapping="no" uniqueIDRef="UID_OBJ_2000"/>
          <CANopenObject index="2001" name="Offset" objectType="7" dataType="0003" lowLimit="-100" highLimit="0x0064" accessType="rw" defaultValue="-5" PDOmapping="TPDO" uniqueIDRef="UID_OBJ_2001"/>
          <CANopenObject index="2002" name="Calibration" objectType="7" dataType="000A" accessType="rw" defaultValue="00FF10AB" actualValue="00FF10AB" PDOmapping="no" uniqueIDRef="UID_OBJ_2002"/>
          <CANopenObject index="2003" name="Firmware" objectType="2" dataType="000F" accessType="wo" PDOmapping="no" uniqueIDRef="UID_OBJ_2003"/>
          <CANopenObject index="2004" name="Counter" objectType="7" dataType="001B" accessType="ro" defaultValue="0xFFFFFFFFFFFFFFFF" actualValue="0xFFFFFFFFFFFFFFFF" PDOmapping="no" uniqueIDRef="UID_OBJ_2004"/>
          <CANopenObject index="2005" name="Trim" objectType="7" dataType="0010" accessType="rw" defaultValue="-1" actualValue="-1" PDOmapping="no" objFlags="0001" uniqueIDRef="UID_OBJ_2005"/>
          <CANopenObject index="6000" name="Digital Inputs" objectType="8" objFlags="0001" subNumber="3">
            <CANopenSubObject subIndex="00" name="Highest Sub-Index" objectType="7" dataType="0005" accessType="ro" defaultValue="0x02" actualValue="0x02" PDOmapping="no" uniqueIDRef="UID_SUB_600000"/>
            <CANopenSubObject subIndex="01" name="Inputs 1 to 8" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" PDOmapping="TPDO" uniqueIDRef="UID_SUB_600001"/>
            <CANopenSubObject subIndex="02" name="Inputs 9 to 16" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" PDOmapping="TPDO" uniqueIDRef="UID_SUB_600002"/>
          </CANopenObject>
          <CANopenObject index="6200" name="Digital Outputs" objectType="8" subNumber="2">
            <CANopenSubObject subIndex="00" name="Highest Sub-Index" objectType="7" dataType="0005" accessType="ro" defaultValue="0x01" actualValue="0x01" PDOmapping="no" uniqueIDRef="UID_SUB_620000"/>
            <CANopenSubObject subIndex="01" name="Outputs 1 to 8" objectType="7" dataType="0005" accessType="rw" defaultValue="0x00" PDOmapping="RPDO" uniqueIDRef="UID_SUB_620001"/>
          </CANopenObject>
        </co:CANopenObjectList>
        <dummyUsage>
          <dummy entry="Dummy0001=0"/>
          <dummy entry="Dummy0002=1"/>
          <dummy entry="Dummy0003=1"/>
          <dummy entry="Dummy0004=0"/>
          <dummy entry="Dummy0005=1"/>
          <dummy entry="Dummy0006=1"/>
          <dummy entry="Dummy0007=0"/>
        </dummyUsage>
      </ApplicationLayers>
      <TransportLayers>
        <PhysicalLayer>
          <baudRate>
            <supportedBaudRate value="125 Kbps"/>
            <supportedBaudRate value="250 Kbps"/>
            <supportedBaudRate value="500 Kbps"/>
          </baudRate>
        </PhysicalLayer>
      </TransportLayers>
      <NetworkManagement>
        <CANopenGeneralFeatures groupMessaging="false" dynamicChannels="0" granularity="8" nrOfRxPDO="1" nrOfTxPDO="1" bootUpSlave="true" layerSettingServiceSlave="false"/>
        <CANopenMasterFeatures bootUpMaster="false"/>
        <deviceCommissioning NodeID="5" nodeName="IO Device" actualBaudRate="" networkNumber="0" networkName="" CANopenManager="false"/>
      </NetworkManagement>
    </ProfileBody>
  </ISO15745Profile>
</ISO15745ProfileContainer>
